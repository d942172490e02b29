package org.auvsim.viz.window;

import java.awt.KeyboardFocusManager;

import javax.swing.event.DocumentEvent;
import javax.swing.event.DocumentListener;
import javax.swing.text.JTextComponent;

/** Hears of each change of a text. */
final class Typing implements DocumentListener {
    private final Runnable then;

    private Typing(Runnable then) {
        this.then = then;
    }

    static DocumentListener calls(Runnable then) {
        return new Typing(then);
    }

    /** Whether keys go into a text that can be changed. */
    static boolean isUnderWay() {
        return KeyboardFocusManager.getCurrentKeyboardFocusManager().getFocusOwner()
                        instanceof JTextComponent text
                && text.isEditable();
    }

    @Override
    public void insertUpdate(DocumentEvent e) {
        then.run();
    }

    @Override
    public void removeUpdate(DocumentEvent e) {
        then.run();
    }

    @Override
    public void changedUpdate(DocumentEvent e) {
        then.run();
    }
}
