package org.auvsim.core.entity;

import static org.auvsim.core.entity.SpatialColumns.ADDED;
import static org.auvsim.core.entity.SpatialColumns.ADDED_CROSS;
import static org.auvsim.core.entity.SpatialColumns.CENTRE;
import static org.auvsim.core.entity.SpatialColumns.INVERSE;
import static org.auvsim.core.entity.SpatialColumns.SYMMETRIC;

import java.util.Arrays;

/**
 * The equations of {@link SpatialInertia} for all bodies of a block that have one, but for the
 * mounted ones: an array a quantity, in loops short enough for the compiler to vectorise them.
 */
public final class SpatialBlock {
    private final double[][] constants;

    /** Momenta, then velocities relative to the water, and velocities, in body axes. */
    private final double[][] momenta;

    private final double[][] velocities;

    /** The water's velocity in body axes, and a vector between. */
    private final double[][] water;

    private final double[][] between;

    /** Velocities in world axes. */
    private final double[][] inWorld;

    /** What momenta carried along turn a body by (N m, world): u x p_A - v x P. */
    private final double[][] carried;

    /** Whether a body's motion is computed here. */
    private final boolean[] isHere;

    private boolean areAllHere;
    private boolean isAnyHere;
    private boolean isAnyMounted;

    SpatialBlock(int capacity) {
        constants = new double[SpatialColumns.COLUMNS][capacity];
        momenta = new double[6][capacity];
        velocities = new double[6][capacity];
        water = new double[3][capacity];
        between = new double[3][capacity];
        inWorld = new double[6][capacity];
        carried = new double[3][capacity];
        isHere = new boolean[capacity];
    }

    /** Copies the constants of the block's bodies. */
    void load(Block b, SpatialColumns columns) {
        columns.gather(b, constants);
        areAllHere = true;
        isAnyHere = false;
        isAnyMounted = false;
        for (int i = 0; i < b.count; i++) {
            SpatialInertia inertia = b.inertia(i);
            isHere[i] = inertia != null && inertia.free == null;
            areAllHere &= isHere[i];
            isAnyHere |= isHere[i];
            isAnyMounted |= inertia != null && inertia.free != null;
        }
    }

    /** Fills the velocities of the bodies; rotation matrices and water velocities are there. */
    public void move(Block b) {
        if (isAnyHere) {
            b.toBody(
                    momenta[0],
                    momenta[1],
                    momenta[2],
                    b.state[BodyState.PX],
                    b.state[BodyState.PY],
                    b.state[BodyState.PZ]);
            b.toBody(
                    momenta[3],
                    momenta[4],
                    momenta[5],
                    b.state[BodyState.LX],
                    b.state[BodyState.LY],
                    b.state[BodyState.LZ]);
            if (b.hasWater) {
                addFlow(b);
            }
            for (int row = 0; row < 6; row++) {
                solve(b.count, row, velocities[row]);
            }
            toWorld(b, velocities, 0, inWorld, 0);
            toWorld(b, velocities, 3, inWorld, 3);
            carry(b);
            hand(b);
        }
        for (int i = 0; isAnyMounted && i < b.count; i++) {
            SpatialInertia inertia = b.inertia(i);
            if (inertia != null && !isHere[i]) {
                inertia.move(b, i);
            }
        }
    }

    private static void toWorld(Block b, double[][] from, int f, double[][] to, int t) {
        b.toWorld(to[t], to[t + 1], to[t + 2], from[f], from[f + 1], from[f + 2]);
    }

    /** The element of the inverse at a row and a column. */
    private double[] inverse(int row, int column) {
        int r = Math.min(row, column);
        return constants[INVERSE + r * 6 - r * (r - 1) / 2 + Math.abs(row - column)];
    }

    private double[] added(int row, int column) {
        return column < 3
                ? constants[ADDED + SYMMETRIC[3 * row + column]]
                : constants[ADDED_CROSS + 3 * row + column - 3];
    }

    /** Adds the momentum MA nu_c of the water that flows. */
    private void addFlow(Block b) {
        b.toBody(water[0], water[1], water[2], b.ux, b.uy, b.uz);
        for (int row = 0; row < 3; row++) {
            add(b.count, momenta[row], added(row, 0), added(row, 1), added(row, 2), water, 0);
            add(b.count, momenta[3 + row], added(0, 3 + row), added(1, 3 + row), added(2, 3 + row), water, 0);
        }
    }

    private static void add(
            int count, double[] to, double[] a, double[] b, double[] c, double[][] v, int at) {
        double[] x = v[at];
        double[] y = v[at + 1];
        double[] z = v[at + 2];
        for (int i = 0; i < count; i++) {
            to[i] += a[i] * x[i] + b[i] * y[i] + c[i] * z[i];
        }
    }

    private void solve(int count, int row, double[] to) {
        double[] a = inverse(row, 0);
        double[] b = inverse(row, 1);
        double[] c = inverse(row, 2);
        double[] x = momenta[0];
        double[] y = momenta[1];
        double[] z = momenta[2];
        for (int i = 0; i < count; i++) {
            to[i] = a[i] * x[i] + b[i] * y[i] + c[i] * z[i];
        }
        add(count, to, inverse(row, 3), inverse(row, 4), inverse(row, 5), momenta, 3);
    }

    private void carry(Block b) {
        for (int axis = 0; axis < 3; axis++) {
            int y = (axis + 1) % 3;
            int z = (axis + 2) % 3;
            subtractCross(
                    b.count,
                    carried[axis],
                    inWorld[y],
                    inWorld[z],
                    b.state[BodyState.PX + y],
                    b.state[BodyState.PX + z]);
        }
        if (b.hasWater) {
            carryWater(b);
        }
    }

    /** -a x b, one component. */
    private static void subtractCross(
            int count, double[] to, double[] ay, double[] az, double[] by, double[] bz) {
        for (int i = 0; i < count; i++) {
            to[i] = az[i] * by[i] - ay[i] * bz[i];
        }
    }

    private static void addCross(
            int count, double[] to, double[] ay, double[] az, double[] by, double[] bz) {
        for (int i = 0; i < count; i++) {
            to[i] += ay[i] * bz[i] - az[i] * by[i];
        }
    }

    /** u x p_A with the linear momentum of the carried water, p_A = R (MA (nu - nu_c)). */
    private void carryWater(Block b) {
        for (int axis = 0; axis < 3; axis++) {
            for (int i = 0; i < b.count; i++) {
                water[axis][i] = velocities[axis][i] - water[axis][i];
            }
        }
        for (int row = 0; row < 3; row++) {
            Arrays.fill(between[row], 0, b.count, 0);
            add(b.count, between[row], added(row, 0), added(row, 1), added(row, 2), water, 0);
            add(b.count, between[row], added(row, 3), added(row, 4), added(row, 5), velocities, 3);
        }
        toWorld(b, between, 0, momenta, 0);
        addCross(b.count, carried[0], b.uy, b.uz, momenta[1], momenta[2]);
        addCross(b.count, carried[1], b.uz, b.ux, momenta[2], momenta[0]);
        addCross(b.count, carried[2], b.ux, b.uy, momenta[0], momenta[1]);
    }

    /** Hands the velocities over to the block. */
    private void hand(Block b) {
        hand(b.count, inWorld[0], b.vx);
        hand(b.count, inWorld[1], b.vy);
        hand(b.count, inWorld[2], b.vz);
        hand(b.count, inWorld[3], b.wx);
        hand(b.count, inWorld[4], b.wy);
        hand(b.count, inWorld[5], b.wz);
        hand(b.count, velocities[3], b.bodyWx);
        hand(b.count, velocities[4], b.bodyWy);
        hand(b.count, velocities[5], b.bodyWz);
    }

    private void hand(int count, double[] from, double[] to) {
        if (areAllHere) {
            System.arraycopy(from, 0, to, 0, count);
            return;
        }
        for (int i = 0; i < count; i++) {
            if (isHere[i]) {
                to[i] = from[i];
            }
        }
    }

    /** Completes torques, and keeps what acts on mounted bodies to their free directions. */
    public void complete(Block b) {
        if (areAllHere) {
            addCarried(b.count, b.tx, carried[0]);
            addCarried(b.count, b.ty, carried[1]);
            addCarried(b.count, b.tz, carried[2]);
            return;
        }
        for (int i = 0; i < b.count; i++) {
            SpatialInertia inertia = b.inertia(i);
            if (isHere[i]) {
                b.tx[i] += carried[0][i];
                b.ty[i] += carried[1][i];
                b.tz[i] += carried[2][i];
            } else if (inertia != null) {
                inertia.complete(b, i);
            }
        }
    }

    private static void addCarried(int count, double[] to, double[] what) {
        for (int i = 0; i < count; i++) {
            to[i] += what[i];
        }
    }

    /** Whether the motion of all bodies of the block is computed here. */
    public boolean areAllHere() {
        return areAllHere;
    }

    /** Hands over the velocities relative to the water, in body axes, of all bodies. */
    void relative(int count, boolean inWater, double[][] to) {
        for (int axis = 0; axis < 3; axis++) {
            double[] from = inWater ? water[axis] : velocities[axis];
            System.arraycopy(from, 0, to[axis], 0, count);
        }
    }

    /** Fills the places of the bodies' centres of mass (m from the origins, world axes). */
    public void centres(Block b, double[] x, double[] y, double[] z) {
        b.toWorld(x, y, z, constants[CENTRE], constants[CENTRE + 1], constants[CENTRE + 2]);
    }
}
