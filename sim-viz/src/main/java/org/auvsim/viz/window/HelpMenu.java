package org.auvsim.viz.window;

import org.auvsim.viz.drawing.Layer;

import java.awt.BorderLayout;
import java.awt.Window;
import java.util.Locale;
import java.util.stream.Collectors;
import java.util.stream.Stream;

import javax.swing.BorderFactory;
import javax.swing.JDialog;
import javax.swing.JLabel;
import javax.swing.JMenu;
import javax.swing.JPanel;
import javax.swing.WindowConstants;

/** The keys and what the mouse does. */
final class HelpMenu {
    private HelpMenu() {}

    /** All keys, as a page. */
    static String keys() {
        return """
        <html><table cellpadding=3>
        <tr><td><b>Left drag</b><td>goes around the target
        <tr><td><b>Middle or Shift+left drag</b><td>moves the target
        <tr><td><b>Wheel</b><td>goes nearer or away
        <tr><td><b>Click, double click</b><td>selects an object, looks at it
        <tr><td><b>1 2 3 4 0</b><td>from above, the side, ahead, behind; everything
        <tr><td><b>F</b><td>follows the selected object
        <tr><td><b>Ctrl+P, Ctrl+O</b><td>in perspective, orthographic
        <tr><td><b>Ctrl+Shift+D</b><td>dark or light
        <tr><td><b>Alt+Shift and a letter</b><td>shows a layer or leaves it out: %s
        <tr><td><b>Space</b><td>pauses or goes on
        <tr><td><b>Comma, period</b><td>a step back (recordings), a step on
        <tr><td><b>Ctrl+S, Ctrl+Shift+R</b><td>saves the picture, records frames
        <tr><td><b>Ctrl+T, Ctrl+L</b><td>takes a snapshot, loads a scenario
        <tr><td><b>Ctrl+Q</b><td>closes the viewer
        <tr><td><b>Ctrl+D</b><td>drives the selected object:
        <tr><td><b>W S</b><td>ahead and astern
        <tr><td><b>A D, left and right</b><td>the bow to port and starboard
        <tr><td><b>Q E</b><td>to port and starboard
        <tr><td><b>R F</b><td>up and down
        <tr><td><b>Up and down</b><td>the bow up and down
        <tr><td><b>Gamepad</b><td>left stick ahead and yaw, right up and aside, triggers pitch
        </table></html>\
        """
                .formatted(
                        Stream.of(Layer.values())
                                .map(
                                        layer ->
                                                layer.key()
                                                        + " "
                                                        + layer.word().toLowerCase(Locale.ROOT))
                                .collect(Collectors.joining(", ")));
    }

    static JMenu menu(Window window) {
        JMenu menu = new JMenu("Help");
        menu.setName("menu-help");
        menu.setMnemonic('H');
        menu.add(new Act("Keys and mouse", () -> show(window)).key("F1")).setName("help-keys");
        return menu;
    }

    private static void show(Window window) {
        JDialog dialog = new JDialog(window, "Keys and mouse");
        dialog.setName("keys");
        dialog.setDefaultCloseOperation(WindowConstants.DISPOSE_ON_CLOSE);
        JLabel words = new JLabel(keys());
        words.setBorder(BorderFactory.createEmptyBorder(12, 16, 16, 24));
        JPanel below = new JPanel();
        below.add(Closing.of(dialog));
        dialog.add(words);
        dialog.add(below, BorderLayout.SOUTH);
        dialog.pack();
        dialog.setLocationRelativeTo(window);
        dialog.setVisible(true);
    }
}
