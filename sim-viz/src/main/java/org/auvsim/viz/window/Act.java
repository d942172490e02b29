package org.auvsim.viz.window;

import org.auvsim.auvsml.Role;

import java.awt.event.ActionEvent;
import java.awt.event.KeyEvent;
import java.util.Optional;
import java.util.function.Supplier;

import javax.swing.AbstractAction;
import javax.swing.Action;
import javax.swing.KeyStroke;

/** Something that a menu, a button or a key does. */
final class Act extends AbstractAction {
    private static final long serialVersionUID = 1L;
    private final transient Runnable deed;
    private String tip = "";

    Act(String words, Runnable deed) {
        super(words);
        this.deed = deed;
    }

    /** The key that does it. One without Ctrl or Alt is left to a text that is typed in. */
    Act key(String stroke) {
        putValue(Action.ACCELERATOR_KEY, KeyStroke.getKeyStroke(stroke));
        return this;
    }

    /** What it tells about itself. */
    Act tip(String words) {
        tip = words;
        putValue(Action.SHORT_DESCRIPTION, words);
        return this;
    }

    /** Can be done by clients of a role alone; says so where it cannot. */
    Act needs(Desk desk, Role role) {
        return unless(desk, () -> desk.hindrance(role));
    }

    /** Can be done unless there is a hindrance, which it tells. */
    Act unless(Desk desk, Supplier<Optional<String>> hindrance) {
        desk.onRefresh(() -> hinder(hindrance.get()));
        hinder(hindrance.get());
        return this;
    }

    private void hinder(Optional<String> why) {
        setEnabled(why.isEmpty());
        putValue(Action.SHORT_DESCRIPTION, why.orElse(tip.isEmpty() ? null : tip));
    }

    @Override
    public void actionPerformed(ActionEvent e) {
        boolean isPlain =
                getValue(Action.ACCELERATOR_KEY) instanceof KeyStroke stroke
                        && stroke.getModifiers() == 0
                        && !stroke.isOnKeyRelease()
                        && stroke.getKeyCode() < KeyEvent.VK_F1;
        boolean byKey = e.getModifiers() == 0 && isPlain && Typing.isUnderWay();
        if (!byKey) {
            deed.run();
        }
    }
}
