package org.auvsim.core.effect;

import org.auvsim.core.entity.Block;
import org.auvsim.core.entity.BlockEffect;
import org.auvsim.core.entity.Effect;
import org.auvsim.core.math.Vec3;

import java.util.List;

/**
 * The damping of all bodies of a world; a body without has zeros, a block without is passed over.
 */
final class DampingBlock implements BlockEffect {
    private final double[][] linear;
    private final double[][] quadratic;
    private final boolean[] damped;

    DampingBlock(List<List<Effect>> bySlot) {
        int slots = bySlot.size();
        linear = new double[6][slots];
        quadratic = new double[6][slots];
        damped = new boolean[slots];
        for (int slot = 0; slot < slots; slot++) {
            for (Effect effect : bySlot.get(slot)) {
                Damping damping = (Damping) effect;
                add(linear, 0, slot, damping.linear());
                add(linear, 3, slot, damping.angularLinear());
                add(quadratic, 0, slot, damping.quadratic());
                add(quadratic, 3, slot, damping.angularQuadratic());
                damped[slot] = true;
            }
        }
    }

    private static void add(double[][] columns, int column, int slot, Vec3 k) {
        columns[column][slot] += k.x();
        columns[column + 1][slot] += k.y();
        columns[column + 2][slot] += k.z();
    }

    @Override
    public void add(Block b) {
        if (!touches(b)) {
            return;
        }
        double[][] v = b.scratch;
        subtract(b, v[3], b.vx, b.ux);
        subtract(b, v[4], b.vy, b.uy);
        subtract(b, v[5], b.vz, b.uz);
        b.toBody(v[0], v[1], v[2], v[3], v[4], v[5]);
        damp(b, 0);
        b.addToWorld(b.fx, b.fy, b.fz, v[0], v[1], v[2]);
        b.toBody(v[0], v[1], v[2], b.wx, b.wy, b.wz);
        damp(b, 3);
        b.addToWorld(b.tx, b.ty, b.tz, v[0], v[1], v[2]);
    }

    private boolean touches(Block b) {
        for (int i = 0; i < b.count; i++) {
            if (damped[b.slot(i)]) {
                return true;
            }
        }
        return false;
    }

    private static void subtract(Block b, double[] to, double[] from, double[] what) {
        for (int i = 0; i < b.count; i++) {
            to[i] = from[i] - what[i];
        }
    }

    /** Turns the three velocity components in scratch into the damping forces along them. */
    private void damp(Block b, int column) {
        double[] a = b.scratch[6];
        double[] k = b.scratch[7];
        for (int axis = 0; axis < 3; axis++) {
            b.gather(linear[column + axis], a);
            b.gather(quadratic[column + axis], k);
            damp(b, b.scratch[axis], a, k);
        }
    }

    private static void damp(Block b, double[] v, double[] a, double[] k) {
        for (int i = 0; i < b.count; i++) {
            v[i] = -(a[i] + k[i] * Math.abs(v[i])) * v[i];
        }
    }
}
