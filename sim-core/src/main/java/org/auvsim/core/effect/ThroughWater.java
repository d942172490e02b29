package org.auvsim.core.effect;

import org.auvsim.core.entity.Block;

/**
 * How the bodies of a block move through the water, and what it does to them, both in body axes and
 * in the order of {@link org.auvsim.core.entity.MotionAxis}: the block's scratch holds six columns
 * of velocities, then six of forces and torques.
 */
final class ThroughWater {
    /** The first of the block's scratch columns of forces and torques. */
    static final int FORCE = 6;

    /** The first that is free for other use. */
    static final int FREE = 12;

    private ThroughWater() {}

    /** Whether a body of the block is one of these, by slot. */
    static boolean isAnyOf(Block b, boolean[] these) {
        for (int i = 0; i < b.count; i++) {
            if (these[b.slot(i)]) {
                return true;
            }
        }
        return false;
    }

    /**
     * Fills the velocities: that of the origin relative to the water (m/s), that of turning
     * (rad/s).
     */
    static void measure(Block b) {
        double[][] s = b.scratch;
        double[][] relative = b.relativeVelocities();
        System.arraycopy(relative[0], 0, s[0], 0, b.count);
        System.arraycopy(relative[1], 0, s[1], 0, b.count);
        System.arraycopy(relative[2], 0, s[2], 0, b.count);
        System.arraycopy(b.bodyWx, 0, s[3], 0, b.count);
        System.arraycopy(b.bodyWy, 0, s[4], 0, b.count);
        System.arraycopy(b.bodyWz, 0, s[5], 0, b.count);
    }

    /** Adds the forces (N) and torques (N m) to those of the block. */
    static void push(Block b) {
        double[][] s = b.scratch;
        b.addToWorld(b.fx, b.fy, b.fz, s[FORCE], s[FORCE + 1], s[FORCE + 2]);
        b.addToWorld(b.tx, b.ty, b.tz, s[FORCE + 3], s[FORCE + 4], s[FORCE + 5]);
    }
}
