package org.auvsim.core.step;

import java.util.Arrays;

/** The bodies that begin new segments at one instant, by their slots. */
final class Movers {
    private final BodyTraits traits;
    private int[] slots = new int[16];
    private int count;

    Movers(BodyTraits traits) {
        this.traits = traits;
    }

    void clear() {
        count = 0;
    }

    /** Those of two, which may be one, that are not fixed. */
    void set(int a, int b) {
        clear();
        if (!traits.isFixed[a]) {
            add(a);
        }
        if (b != a && !traits.isFixed[b]) {
            add(b);
        }
    }

    void add(int body) {
        if (count == slots.length) {
            slots = Arrays.copyOf(slots, 2 * count);
        }
        slots[count++] = body;
    }

    int count() {
        return count;
    }

    /** The bodies; {@link #count} of them. */
    int[] slots() {
        return slots;
    }
}
