package org.auvsim.core.effect;

import org.auvsim.core.entity.Block;
import org.auvsim.core.entity.BlockEffect;

/** The Magnus forces on all bodies of a world; a body without has a coefficient of 0. */
final class MagnusBlock implements BlockEffect {
    private final double[] coefficients;

    /** With these coefficients (kg), by slot. */
    MagnusBlock(double[] coefficients) {
        this.coefficients = coefficients;
    }

    @Override
    public void add(Block b) {
        double[] c = b.scratch[0];
        b.gather(coefficients, c);
        add(b, c, b.fx, b.wy, b.vz, b.uz, b.wz, b.vy, b.uy);
        add(b, c, b.fy, b.wz, b.vx, b.ux, b.wx, b.vz, b.uz);
        add(b, c, b.fz, b.wx, b.vy, b.uy, b.wy, b.vx, b.ux);
    }

    /** One component of c w x (v - u): c (w1 (v2 - u2) - w2 (v1 - u1)). */
    private static void add(
            Block b,
            double[] c,
            double[] force,
            double[] w1,
            double[] v2,
            double[] u2,
            double[] w2,
            double[] v1,
            double[] u1) {
        for (int i = 0; i < b.count; i++) {
            force[i] += c[i] * (w1[i] * (v2[i] - u2[i]) - w2[i] * (v1[i] - u1[i]));
        }
    }

    @Override
    public boolean mayTurn() {
        return false;
    }

    @Override
    public boolean readsOrientation() {
        return false;
    }
}
