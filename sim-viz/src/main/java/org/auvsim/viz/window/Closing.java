package org.auvsim.viz.window;

import java.awt.event.KeyEvent;

import javax.swing.JButton;
import javax.swing.JComponent;
import javax.swing.JDialog;
import javax.swing.KeyStroke;
import javax.swing.WindowConstants;

/** How a dialog is closed: by Escape, and by a button. */
final class Closing {
    private Closing() {}

    /** Lets Escape close a dialog; a button that does so, too. */
    static JButton of(JDialog dialog) {
        dialog.getRootPane()
                .registerKeyboardAction(
                        e -> close(dialog),
                        KeyStroke.getKeyStroke(KeyEvent.VK_ESCAPE, 0),
                        JComponent.WHEN_IN_FOCUSED_WINDOW);
        JButton button = new JButton("Close");
        button.setName("close-dialog");
        button.addActionListener(e -> close(dialog));
        return button;
    }

    /** As its own cross does: for good, or until it is opened again. */
    private static void close(JDialog dialog) {
        if (dialog.getDefaultCloseOperation() == WindowConstants.DISPOSE_ON_CLOSE) {
            dialog.dispose();
        } else {
            dialog.setVisible(false);
        }
    }
}
