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

    /**
     * Fills the velocities: that of the origin relative to the water (m/s), that of turning
     * (rad/s).
     */
    static void measure(Block b) {
        double[][] s = b.scratch;
        subtract(b, s[FORCE], b.vx, b.ux);
        subtract(b, s[FORCE + 1], b.vy, b.uy);
        subtract(b, s[FORCE + 2], b.vz, b.uz);
        b.toBody(s[0], s[1], s[2], s[FORCE], s[FORCE + 1], s[FORCE + 2]);
        b.toBody(s[3], s[4], s[5], b.wx, b.wy, b.wz);
    }

    private static void subtract(Block b, double[] to, double[] from, double[] what) {
        for (int i = 0; i < b.count; i++) {
            to[i] = from[i] - what[i];
        }
    }

    /** Adds the forces (N) and torques (N m) to those of the block. */
    static void push(Block b) {
        double[][] s = b.scratch;
        b.addToWorld(b.fx, b.fy, b.fz, s[FORCE], s[FORCE + 1], s[FORCE + 2]);
        b.addToWorld(b.tx, b.ty, b.tz, s[FORCE + 3], s[FORCE + 4], s[FORCE + 5]);
    }
}
