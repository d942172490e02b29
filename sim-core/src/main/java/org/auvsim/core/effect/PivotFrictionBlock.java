package org.auvsim.core.effect;

import org.auvsim.core.entity.Block;
import org.auvsim.core.entity.BlockEffect;
import org.auvsim.core.entity.Effect;

import java.util.Arrays;
import java.util.List;

/** The pivot frictions of all bodies of a world, at most one a body; a body without has zeros. */
final class PivotFrictionBlock implements BlockEffect {
    private final double[] coulomb;
    private final double[] viscous;
    private final double[] slipRate;

    PivotFrictionBlock(List<List<Effect>> bySlot) {
        coulomb = new double[bySlot.size()];
        viscous = new double[bySlot.size()];
        slipRate = new double[bySlot.size()];
        Arrays.fill(slipRate, 1);
        for (int slot = 0; slot < coulomb.length; slot++) {
            for (Effect effect : bySlot.get(slot)) {
                PivotFriction friction = (PivotFriction) effect;
                coulomb[slot] = friction.coulomb();
                viscous[slot] = friction.viscous();
                slipRate[slot] = friction.slipRate();
            }
        }
    }

    @Override
    public void add(Block b) {
        double[] factor = b.scratch[0];
        b.gather(coulomb, b.scratch[1]);
        b.gather(viscous, b.scratch[2]);
        b.gather(slipRate, b.scratch[3]);
        factors(b, factor, b.scratch[1], b.scratch[2], b.scratch[3]);
        subtract(b.count, b.tx, factor, b.wx);
        subtract(b.count, b.ty, factor, b.wy);
        subtract(b.count, b.tz, factor, b.wz);
    }

    private static void factors(Block b, double[] to, double[] t, double[] c, double[] slip) {
        double[] x = b.wx;
        double[] y = b.wy;
        double[] z = b.wz;
        for (int i = 0; i < b.count; i++) {
            double rate = Math.sqrt(x[i] * x[i] + y[i] * y[i] + z[i] * z[i]);
            to[i] = t[i] / Math.max(rate, slip[i]) + c[i];
        }
    }

    private static void subtract(int count, double[] torque, double[] factor, double[] w) {
        for (int i = 0; i < count; i++) {
            torque[i] -= factor[i] * w[i];
        }
    }

    /** What does not turn is not turned by it. */
    @Override
    public boolean mayTurn() {
        return false;
    }

    @Override
    public boolean readsOrientation() {
        return false;
    }
}
