package org.auvsim.core.effect;

import org.auvsim.core.entity.Block;
import org.auvsim.core.entity.BodyState;
import org.auvsim.core.entity.Effect;

import java.util.List;

/**
 * The central forces of all bodies of a world, at most one a body; one of 0 N for a body without.
 */
final class CentralForceBlock implements PlainForce {
    /** Makes any difference of squares that is a number at all one that is beyond 1. */
    private static final double STEEP = 1e300;

    private final double[] force;
    private final double[] restSquared;
    private final double[] x;
    private final double[] y;
    private final double[] z;

    CentralForceBlock(List<List<Effect>> bySlot) {
        int slots = bySlot.size();
        force = new double[slots];
        restSquared = new double[slots];
        x = new double[slots];
        y = new double[slots];
        z = new double[slots];
        for (int slot = 0; slot < slots; slot++) {
            for (Effect effect : bySlot.get(slot)) {
                set(slot, (CentralForce) effect);
            }
        }
    }

    private void set(int slot, CentralForce effect) {
        force[slot] = effect.force();
        restSquared[slot] = effect.restRadius() * effect.restRadius();
        x[slot] = effect.target().x();
        y[slot] = effect.target().y();
        z[slot] = effect.target().z();
    }

    @Override
    public void add(Block b) {
        double[][] s = b.scratch;
        b.gather(x, s[0]);
        b.gather(y, s[1]);
        b.gather(z, s[2]);
        b.gather(force, s[3]);
        b.gather(restSquared, s[4]);
        lead(b, s[0], s[1], s[2]);
        scale(b.count, s[3], s[4], s[0], s[1], s[2]);
        push(b, s[3], s[0], s[1], s[2]);
    }

    /** Turns targets into ways to them. */
    private static void lead(Block b, double[] targetX, double[] targetY, double[] targetZ) {
        double[] x = b.state[BodyState.X];
        double[] y = b.state[BodyState.Y];
        double[] z = b.state[BodyState.Z];
        for (int i = 0; i < b.count; i++) {
            targetX[i] -= x[i];
            targetY[i] -= y[i];
            targetZ[i] -= z[i];
        }
    }

    /**
     * Turns forces into forces a metre of way, or into 0 within the rest radius. Without a branch
     * and without a select, neither of which the compiler vectorises: the switch is a clamped line
     * so steep that it is 0 or 1.
     */
    private static void scale(
            int count, double[] force, double[] rest, double[] dx, double[] dy, double[] dz) {
        for (int i = 0; i < count; i++) {
            double d = dx[i] * dx[i] + dy[i] * dy[i] + dz[i] * dz[i];
            double on = Math.min(1, Math.max(0, (d - rest[i]) * STEEP));
            force[i] = on * force[i] / Math.sqrt(d + Double.MIN_NORMAL);
        }
    }

    private static void push(Block b, double[] scale, double[] x, double[] y, double[] z) {
        double[] fx = b.fx;
        double[] fy = b.fy;
        double[] fz = b.fz;
        for (int i = 0; i < b.count; i++) {
            fx[i] += scale[i] * x[i];
            fy[i] += scale[i] * y[i];
            fz[i] += scale[i] * z[i];
        }
    }
}
