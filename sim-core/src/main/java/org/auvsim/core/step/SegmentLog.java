package org.auvsim.core.step;

import org.auvsim.core.entity.BodyState;

import java.util.Arrays;

/** The states that bodies had before the frame changed them, so that a frame can be undone. */
final class SegmentLog {
    private final BodyState bodies;
    private final boolean[] isKept;
    private int[] slots = new int[16];
    private double[] states = new double[16 * BodyState.COLUMNS];
    private int count;

    SegmentLog(BodyState bodies) {
        this.bodies = bodies;
        isKept = new boolean[bodies.count()];
    }

    void clear() {
        for (int k = 0; k < count; k++) {
            isKept[slots[k]] = false;
        }
        count = 0;
    }

    /** Keeps the state of a body, the first time in a frame. */
    void keep(int slot) {
        if (isKept[slot]) {
            return;
        }
        if (count == slots.length) {
            slots = Arrays.copyOf(slots, 2 * count);
            states = Arrays.copyOf(states, 2 * states.length);
        }
        for (int c = 0; c < BodyState.COLUMNS; c++) {
            states[count * BodyState.COLUMNS + c] = bodies.column(c)[slot];
        }
        isKept[slot] = true;
        slots[count++] = slot;
    }

    /** Gives all bodies back what they had. */
    void restore() {
        for (int k = 0; k < count; k++) {
            for (int c = 0; c < BodyState.COLUMNS; c++) {
                bodies.column(c)[slots[k]] = states[k * BodyState.COLUMNS + c];
            }
        }
        clear();
    }
}
