package org.auvsim.viz.window;

import org.auvsim.viz.driving.Wanted;

import java.awt.event.KeyEvent;
import java.util.HashSet;
import java.util.Set;

/**
 * The keys that are held down. Some systems tell of a held key as of one let go and pressed again
 * at once; so a key counts as let go only at the next {@link #settle}.
 */
final class HeldKeys {
    private static final Set<Integer> DRIVING =
            Set.of(
                    KeyEvent.VK_W,
                    KeyEvent.VK_S,
                    KeyEvent.VK_A,
                    KeyEvent.VK_D,
                    KeyEvent.VK_Q,
                    KeyEvent.VK_E,
                    KeyEvent.VK_R,
                    KeyEvent.VK_F,
                    KeyEvent.VK_UP,
                    KeyEvent.VK_DOWN,
                    KeyEvent.VK_LEFT,
                    KeyEvent.VK_RIGHT);

    private final Set<Integer> held = new HashSet<>();
    private final Set<Integer> released = new HashSet<>();

    /** Whether a key drives. */
    static boolean drives(int key) {
        return DRIVING.contains(key);
    }

    void press(int key) {
        held.add(key);
        released.remove(key);
    }

    void release(int key) {
        released.add(key);
    }

    /** Lets go of what was released, some time ago by now. */
    void settle() {
        held.removeAll(released);
        released.clear();
    }

    void letGo() {
        held.clear();
        released.clear();
    }

    /** What they ask for. */
    Wanted wanted() {
        return new Wanted(
                between(KeyEvent.VK_S, KeyEvent.VK_W),
                between(KeyEvent.VK_E, KeyEvent.VK_Q),
                between(KeyEvent.VK_F, KeyEvent.VK_R),
                Math.clamp(
                        between(KeyEvent.VK_D, KeyEvent.VK_A)
                                + between(KeyEvent.VK_RIGHT, KeyEvent.VK_LEFT),
                        -1,
                        1),
                between(KeyEvent.VK_DOWN, KeyEvent.VK_UP));
    }

    private double between(int less, int more) {
        return (held.contains(more) ? 1.0 : 0.0) - (held.contains(less) ? 1.0 : 0.0);
    }
}
