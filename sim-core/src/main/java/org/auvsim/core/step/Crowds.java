package org.auvsim.core.step;

import java.util.Arrays;

/**
 * Tells where so many bodies in contact hit each other in one frame that all cannot be followed: an
 * island is settled anew at each of its collisions, and a body whose islands have had so many
 * members together is crowded. For the rest of the frame whatever it meets stays with it, and what
 * is near to it is held before they meet.
 */
final class Crowds {
    /** Ten collisions a frame in a heap of a hundred bodies. */
    private static final int MOST = 1000;

    private final int[] settled;
    private boolean any;

    Crowds(int bodies) {
        settled = new int[bodies];
    }

    /** A new frame begins. */
    void clear() {
        Arrays.fill(settled, 0);
        any = false;
    }

    /** An island of these bodies has been settled. */
    void settled(int[] members, int count) {
        for (int k = 0; k < count; k++) {
            settled[members[k]] += count;
            any |= settled[members[k]] > MOST;
        }
    }

    boolean any() {
        return any;
    }

    boolean isCrowded(int body) {
        return settled[body] > MOST;
    }
}
