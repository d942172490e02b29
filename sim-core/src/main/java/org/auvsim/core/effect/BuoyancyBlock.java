package org.auvsim.core.effect;

import org.auvsim.core.entity.Block;
import org.auvsim.core.entity.BlockEffect;
import org.auvsim.core.entity.BodyState;
import org.auvsim.core.entity.Effect;

import java.util.Arrays;
import java.util.List;

/** The buoyancy of all bodies of a world, at most one a body. */
final class BuoyancyBlock implements BlockEffect {
    private static final int MASS = 0;
    private static final int ACCELERATION = 1;
    private static final int CENTRE = 2;
    private static final int SURFACE = 5;
    private static final int FADE = 6;

    /** One array a number, by slot. */
    private final double[][] numbers;

    /** Whether a centre of buoyancy is not its body's origin. */
    private boolean isAside;

    BuoyancyBlock(List<List<Effect>> bySlot) {
        numbers = new double[7][bySlot.size()];
        Arrays.fill(numbers[FADE], 1);
        for (int slot = 0; slot < bySlot.size(); slot++) {
            for (Effect effect : bySlot.get(slot)) {
                set(slot, (Buoyancy) effect);
            }
        }
    }

    private void set(int slot, Buoyancy of) {
        numbers[MASS][slot] = of.displacedMass();
        numbers[ACCELERATION][slot] = of.acceleration();
        numbers[CENTRE][slot] = of.centre().x();
        numbers[CENTRE + 1][slot] = of.centre().y();
        numbers[CENTRE + 2][slot] = of.centre().z();
        isAside |= of.centre().norm() > 0;
        numbers[SURFACE][slot] = of.surface();
        numbers[FADE][slot] = of.volume() == 0 ? 1 : of.fade();
    }

    @Override
    public void add(Block b) {
        double[] mass = b.scratch[0];
        double[] x = b.scratch[2];
        double[] y = b.scratch[3];
        double[] z = b.scratch[4];
        b.gather(numbers[MASS], mass);
        centres(b, x, y, z);
        wet(b, mass, z);
        double[] acceleration = b.scratch[1];
        b.gather(numbers[ACCELERATION], acceleration);
        for (int i = 0; i < b.count; i++) {
            double up = mass[i] * acceleration[i];
            b.fz[i] += up;
            b.tx[i] += y[i] * up;
            b.ty[i] -= x[i] * up;
        }
        if (b.hasFlow) {
            accelerate(b, mass, x, y, z);
        }
    }

    /** The centres of buoyancy (m from the origins, world axes). */
    private void centres(Block b, double[] x, double[] y, double[] z) {
        if (!isAside) {
            Arrays.fill(x, 0, b.count, 0);
            Arrays.fill(y, 0, b.count, 0);
            Arrays.fill(z, 0, b.count, 0);
            return;
        }
        b.gather(numbers[CENTRE], b.scratch[5]);
        b.gather(numbers[CENTRE + 1], b.scratch[6]);
        b.gather(numbers[CENTRE + 2], b.scratch[7]);
        b.toWorld(x, y, z, b.scratch[5], b.scratch[6], b.scratch[7]);
    }

    /** Leaves of the displaced masses what is under water. */
    private void wet(Block b, double[] mass, double[] z) {
        double[] surface = b.scratch[5];
        double[] fade = b.scratch[6];
        b.gather(numbers[SURFACE], surface);
        b.gather(numbers[FADE], fade);
        double[] height = b.state[BodyState.Z];
        for (int i = 0; i < b.count; i++) {
            double wave = b.hasFlow ? b.elevation[i] : 0;
            double depth = surface[i] + wave - height[i] - z[i];
            mass[i] *= Math.min(1, Math.max(0, 0.5 + depth / fade[i]));
        }
    }

    /** The displaced mass times the acceleration of the water that passes the origin. */
    private static void accelerate(Block b, double[] mass, double[] x, double[] y, double[] z) {
        double[][] d = b.flow;
        for (int i = 0; i < b.count; i++) {
            double u = b.ux[i];
            double v = b.uy[i];
            double w = b.uz[i];
            double fx = mass[i] * (d[0][i] + d[3][i] * u + d[4][i] * v + d[5][i] * w);
            double fy = mass[i] * (d[1][i] + d[6][i] * u + d[7][i] * v + d[8][i] * w);
            double fz = mass[i] * (d[2][i] + d[9][i] * u + d[10][i] * v + d[11][i] * w);
            b.fx[i] += fx;
            b.fy[i] += fy;
            b.fz[i] += fz;
            b.tx[i] += y[i] * fz - z[i] * fy;
            b.ty[i] += z[i] * fx - x[i] * fz;
            b.tz[i] += x[i] * fy - y[i] * fx;
        }
    }
}
