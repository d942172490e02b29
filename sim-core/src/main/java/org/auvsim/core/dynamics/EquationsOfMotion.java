package org.auvsim.core.dynamics;

import static org.auvsim.core.entity.BodyState.IXX;
import static org.auvsim.core.entity.BodyState.IXY;
import static org.auvsim.core.entity.BodyState.IXZ;
import static org.auvsim.core.entity.BodyState.IYY;
import static org.auvsim.core.entity.BodyState.IYZ;
import static org.auvsim.core.entity.BodyState.IZZ;
import static org.auvsim.core.entity.BodyState.LX;
import static org.auvsim.core.entity.BodyState.LY;
import static org.auvsim.core.entity.BodyState.LZ;
import static org.auvsim.core.entity.BodyState.PX;
import static org.auvsim.core.entity.BodyState.PY;
import static org.auvsim.core.entity.BodyState.PZ;
import static org.auvsim.core.entity.BodyState.QW;
import static org.auvsim.core.entity.BodyState.QX;
import static org.auvsim.core.entity.BodyState.QY;
import static org.auvsim.core.entity.BodyState.QZ;

import org.auvsim.core.entity.Block;
import org.auvsim.core.entity.BlockEffect;
import org.auvsim.core.entity.BodyState;
import org.auvsim.core.entity.Current;
import org.auvsim.core.math.Vec3;

import java.util.Arrays;
import java.util.List;

/**
 * The rigid-body equations in momenta (thesis, Table 5.1; Witkin &amp; Baraff 1997):
 *
 * <pre>dS/dt = P/m    dq/dt = 1/2 [0, w] q    dP/dt = F    dL/dt = tau    w = R I^-1 R^T L</pre>
 *
 * <p>One call evaluates a block of bodies. The loops are short on purpose: each touches few enough
 * arrays for the compiler to vectorise it.
 */
public final class EquationsOfMotion {
    private final BodyState bodies;
    private final BlockEffect[] effects;
    private final Current[] currents;

    /**
     * The equations for the bodies of a world.
     *
     * @param effects what acts on them beside named forces and propulsors, in this order
     * @param currents the water's velocity is their sum
     */
    public EquationsOfMotion(BodyState bodies, List<BlockEffect> effects, List<Current> currents) {
        this.bodies = bodies;
        this.effects = effects.toArray(BlockEffect[]::new);
        this.currents = currents.toArray(Current[]::new);
    }

    /** Copies state and constants of {@code count} bodies from slot {@code first} on. */
    public void load(Block block, int first, int count, double time) {
        block.take(first, count);
        load(block, time);
    }

    /** Copies state and constants of the bodies in the first {@code count} of these slots. */
    public void load(Block block, int[] slots, int count, double time) {
        block.take(slots, count);
        load(block, time);
    }

    private void load(Block block, double time) {
        block.time = time;
        for (int c = 0; c < BodyState.COLUMNS; c++) {
            block.gather(bodies.column(c), block.state[c]);
        }
        for (int e = 0; e < BodyState.ELEMENTS; e++) {
            block.gather(bodies.inverseInertia(e), block.inverseInertia[e]);
        }
        block.gather(bodies.mass(), block.mass);
        block.gather(bodies.inverseMass(), block.inverseMass);
        bodies.applied().load(block);
        block.hasFixed = false;
        for (int i = 0; i < block.count; i++) {
            block.hasFixed |= block.inverseMass[i] == 0;
        }
    }

    /** Fills rotations, velocities, forces, torques and rates of the block from its state. */
    public void evaluate(Block b) {
        rotations(b);
        velocities(b);
        angularVelocities(b);
        waterVelocities(b);
        bodies.applied().write(b);
        for (BlockEffect effect : effects) {
            effect.add(b);
        }
        if (b.hasContactForces) {
            b.addContactForces();
        }
        quaternionRates(b);
        if (b.hasFixed) {
            holdFixed(b);
        }
    }

    /** Scales the quaternions of the block back to length 1. */
    public void normalizeOrientations(Block b) {
        double[] qw = b.state[QW];
        double[] qx = b.state[QX];
        double[] qy = b.state[QY];
        double[] qz = b.state[QZ];
        for (int i = 0; i < b.count; i++) {
            double norm = Math.sqrt(qw[i] * qw[i] + qx[i] * qx[i] + qy[i] * qy[i] + qz[i] * qz[i]);
            double k = 1 / norm;
            qw[i] *= k;
            qx[i] *= k;
            qy[i] *= k;
            qz[i] *= k;
        }
    }

    private static void rotations(Block b) {
        double[] w = b.state[QW];
        double[] x = b.state[QX];
        double[] y = b.state[QY];
        double[] z = b.state[QZ];
        for (int i = 0; i < b.count; i++) {
            b.rxx[i] = 1 - 2 * (y[i] * y[i] + z[i] * z[i]);
            b.rxy[i] = 2 * (x[i] * y[i] - w[i] * z[i]);
            b.rxz[i] = 2 * (x[i] * z[i] + w[i] * y[i]);
        }
        for (int i = 0; i < b.count; i++) {
            b.ryx[i] = 2 * (x[i] * y[i] + w[i] * z[i]);
            b.ryy[i] = 1 - 2 * (x[i] * x[i] + z[i] * z[i]);
            b.ryz[i] = 2 * (y[i] * z[i] - w[i] * x[i]);
        }
        for (int i = 0; i < b.count; i++) {
            b.rzx[i] = 2 * (x[i] * z[i] - w[i] * y[i]);
            b.rzy[i] = 2 * (y[i] * z[i] + w[i] * x[i]);
            b.rzz[i] = 1 - 2 * (x[i] * x[i] + y[i] * y[i]);
        }
    }

    /** Fills the velocities of the origins alone from the state of the block. */
    public void velocities(Block b) {
        scale(b, b.vx, b.state[PX]);
        scale(b, b.vy, b.state[PY]);
        scale(b, b.vz, b.state[PZ]);
    }

    private static void scale(Block b, double[] to, double[] from) {
        double[] by = b.inverseMass;
        for (int i = 0; i < b.count; i++) {
            to[i] = from[i] * by[i];
        }
    }

    /** w = R I^-1 R^T L, through the body's axes. */
    private static void angularVelocities(Block b) {
        double[][] w = b.scratch;
        b.toBody(b.wx, b.wy, b.wz, b.state[LX], b.state[LY], b.state[LZ]);
        weigh(b, w[0], IXX, IXY, IXZ);
        weigh(b, w[1], IXY, IYY, IYZ);
        weigh(b, w[2], IXZ, IYZ, IZZ);
        b.toWorld(b.wx, b.wy, b.wz, w[0], w[1], w[2]);
    }

    private static void weigh(Block b, double[] to, int x, int y, int z) {
        double[] ix = b.inverseInertia[x];
        double[] iy = b.inverseInertia[y];
        double[] iz = b.inverseInertia[z];
        for (int i = 0; i < b.count; i++) {
            to[i] = ix[i] * b.wx[i] + iy[i] * b.wy[i] + iz[i] * b.wz[i];
        }
    }

    private void waterVelocities(Block b) {
        if (currents.length == 0) {
            return;
        }
        Arrays.fill(b.ux, 0, b.count, 0);
        Arrays.fill(b.uy, 0, b.count, 0);
        Arrays.fill(b.uz, 0, b.count, 0);
        for (Current current : currents) {
            for (int i = 0; i < b.count; i++) {
                Vec3 u = current.valueAt(b.position(i), b.time);
                b.ux[i] += u.x();
                b.uy[i] += u.y();
                b.uz[i] += u.z();
            }
        }
    }

    /** Whatever pushes a fixed body, its momenta stay zero. */
    private static void holdFixed(Block b) {
        for (int i = 0; i < b.count; i++) {
            if (b.inverseMass[i] == 0) {
                for (int c = PX; c <= LZ; c++) {
                    b.rate[c][i] = 0;
                }
            }
        }
    }

    private static void quaternionRates(Block b) {
        double[] qw = b.state[QW];
        double[] qx = b.state[QX];
        double[] qy = b.state[QY];
        double[] qz = b.state[QZ];
        double[] dw = b.rate[QW];
        double[] dx = b.rate[QX];
        double[] dy = b.rate[QY];
        double[] dz = b.rate[QZ];
        for (int i = 0; i < b.count; i++) {
            dw[i] = -0.5 * (b.wx[i] * qx[i] + b.wy[i] * qy[i] + b.wz[i] * qz[i]);
            dx[i] = 0.5 * (b.wx[i] * qw[i] + b.wy[i] * qz[i] - b.wz[i] * qy[i]);
        }
        for (int i = 0; i < b.count; i++) {
            dy[i] = 0.5 * (b.wy[i] * qw[i] + b.wz[i] * qx[i] - b.wx[i] * qz[i]);
            dz[i] = 0.5 * (b.wz[i] * qw[i] + b.wx[i] * qy[i] - b.wy[i] * qx[i]);
        }
    }
}
