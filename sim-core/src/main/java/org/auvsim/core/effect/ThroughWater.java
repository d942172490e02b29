package org.auvsim.core.effect;

import org.auvsim.core.entity.Block;

/**
 * How the bodies of a block move through the water, and what it does to them, both in body axes and
 * in the order of {@link org.auvsim.core.entity.MotionAxis}: the first six columns of the block's
 * scratch are forces and torques.
 */
final class ThroughWater {
    /** The number of forces and torques. */
    static final int AXES = 6;

    /** The first of the block's scratch columns that is free for other use. */
    static final int FREE = AXES;

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

    /** One of the velocities: of the origin relative to the water (m/s), of turning (rad/s). */
    static double[] velocity(Block b, int axis) {
        return switch (axis) {
            case 3 -> b.bodyWx;
            case 4 -> b.bodyWy;
            case 5 -> b.bodyWz;
            default -> b.relativeVelocities()[axis];
        };
    }

    /** Adds the forces (N) and torques (N m) to those of the block. */
    static void push(Block b) {
        double[][] s = b.scratch;
        b.addToWorld(b.fx, b.fy, b.fz, s[0], s[1], s[2]);
        b.addToWorld(b.tx, b.ty, b.tz, s[3], s[4], s[5]);
    }
}
