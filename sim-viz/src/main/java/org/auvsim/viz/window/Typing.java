package org.auvsim.viz.window;

import javax.swing.event.DocumentEvent;
import javax.swing.event.DocumentListener;

/** Hears of each change of a text. */
final class Typing implements DocumentListener {
    private final Runnable then;

    private Typing(Runnable then) {
        this.then = then;
    }

    static DocumentListener calls(Runnable then) {
        return new Typing(then);
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
