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
        relativeToBody(b, b.vx, b.vy, b.vz, true);
        damp(b, b.scratchX, 0);
        damp(b, b.scratchY, 1);
        damp(b, b.scratchZ, 2);
        addToWorld(b, b.fx, b.fy, b.fz);
        relativeToBody(b, b.wx, b.wy, b.wz, false);
        damp(b, b.scratchX, 3);
        damp(b, b.scratchY, 4);
        damp(b, b.scratchZ, 5);
        addToWorld(b, b.tx, b.ty, b.tz);
    }

    private boolean touches(Block b) {
        for (int i = 0; i < b.count; i++) {
            if (damped[b.first + i]) {
                return true;
            }
        }
        return false;
    }

    private void relativeToBody(Block b, double[] x, double[] y, double[] z, boolean toWater) {
        for (int i = 0; i < b.count; i++) {
            double dx = toWater ? x[i] - b.ux[i] : x[i];
            double dy = toWater ? y[i] - b.uy[i] : y[i];
            double dz = toWater ? z[i] - b.uz[i] : z[i];
            b.scratchX[i] = b.rxx[i] * dx + b.ryx[i] * dy + b.rzx[i] * dz;
            b.scratchY[i] = b.rxy[i] * dx + b.ryy[i] * dy + b.rzy[i] * dz;
            b.scratchZ[i] = b.rxz[i] * dx + b.ryz[i] * dy + b.rzz[i] * dz;
        }
    }

    /** Turns a velocity component into the damping force along it, in place. */
    private void damp(Block b, double[] v, int axis) {
        double[] a = linear[axis];
        double[] k = quadratic[axis];
        int first = b.first;
        for (int i = 0; i < b.count; i++) {
            v[i] = -(a[first + i] + k[first + i] * Math.abs(v[i])) * v[i];
        }
    }

    private void addToWorld(Block b, double[] x, double[] y, double[] z) {
        for (int i = 0; i < b.count; i++) {
            x[i] += b.rxx[i] * b.scratchX[i] + b.rxy[i] * b.scratchY[i] + b.rxz[i] * b.scratchZ[i];
            y[i] += b.ryx[i] * b.scratchX[i] + b.ryy[i] * b.scratchY[i] + b.ryz[i] * b.scratchZ[i];
            z[i] += b.rzx[i] * b.scratchX[i] + b.rzy[i] * b.scratchY[i] + b.rzz[i] * b.scratchZ[i];
        }
    }
}
