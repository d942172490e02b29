package org.auvsim.core.effect;

import org.auvsim.core.entity.Block;

/** The weights of all bodies of a world; a body without has an acceleration of zero. */
final class GravityBlock implements PlainForce {
    private final double[] downward;

    /** With these accelerations (m/s^2), by slot. */
    GravityBlock(double[] downward) {
        this.downward = downward;
    }

    @Override
    public void add(Block b) {
        double[] mass = b.mass;
        double[] acceleration = b.scratch[0];
        double[] fz = b.fz;
        b.gather(downward, acceleration);
        for (int i = 0; i < b.count; i++) {
            fz[i] -= mass[i] * acceleration[i];
        }
        if (b.hasSpatial) {
            turn(b, acceleration);
        }
    }

    /** Weights at the centres of mass turn bodies about their origins. */
    private static void turn(Block b, double[] acceleration) {
        double[] x = b.scratch[1];
        double[] y = b.scratch[2];
        b.spatial().centres(b, x, y, b.scratch[3]);
        for (int i = 0; i < b.count; i++) {
            b.tx[i] -= y[i] * b.mass[i] * acceleration[i];
            b.ty[i] += x[i] * b.mass[i] * acceleration[i];
        }
    }
}
