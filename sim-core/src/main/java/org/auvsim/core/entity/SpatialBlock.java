package org.auvsim.core.entity;

import static org.auvsim.core.entity.SpatialColumns.CENTRE;
import static org.auvsim.core.entity.SpatialColumns.INVERSE;

/**
 * The equations of {@link SpatialInertia} for all bodies of a block that have one, but for the
 * mounted ones: an array a quantity, in loops short enough for the compiler to vectorise them.
 */
public final class SpatialBlock {
    private final double[][] constants;

    /** Of the constants the inverse inertia, row by row: its upper half twice. */
    private final double[][] inverse = new double[36][];

    /** Momenta, velocities, and velocities relative to the water, in body axes. */
    private final double[][] momenta;

    private final double[][] velocities;
    private final double[][] relative;

    /** The water's velocity in body axes. */
    private final double[][] water;

    /** Momenta less those of the flow; then the carried water's, in body and in world axes. */
    private final double[][] lacking;

    /** Velocities in world axes. */
    private final double[][] inWorld;

    /** What momenta carried along turn a body by (N m, world): u x p_A - v x P. */
    private final double[][] carried;

    /** Whether a body's motion is computed here. */
    private final boolean[] isHere;

    private boolean areSymmetric;
    private boolean areAllHere;
    private boolean isAnyHere;
    private boolean isAnyMounted;

    SpatialBlock(int capacity) {
        constants = new double[SpatialColumns.COLUMNS][capacity];
        for (int row = 0; row < 6; row++) {
            for (int column = 0; column < 6; column++) {
                int r = Math.min(row, column);
                inverse[6 * row + column] =
                        constants[INVERSE + r * 6 - r * (r - 1) / 2 + Math.abs(row - column)];
            }
        }
        momenta = new double[6][capacity];
        velocities = new double[6][capacity];
        relative = new double[3][capacity];
        water = new double[3][capacity];
        lacking = new double[6][capacity];
        inWorld = new double[6][capacity];
        carried = new double[3][capacity];
        isHere = new boolean[capacity];
    }

    /** Copies the constants of the block's bodies. */
    void load(Block b, SpatialColumns columns) {
        columns.gather(b, constants);
        areSymmetric = areSymmetric(b.count);
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
                subtractFlow(b);
            }
            for (int row = 0; row < 6; row++) {
                solve(b.count, b.hasWater ? lacking : momenta, row, velocities[row]);
            }
            if (b.hasWater) {
                addFlow(b.count);
            }
            toWorld(b, velocities, 0, inWorld, 0);
            toWorld(b, velocities, 3, inWorld, 3);
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

    /**
     * What of the momenta is left beside those that a dry body would have if it moved with the
     * water, MRB nu_c: M times the velocities relative to the water.
     */
    private void subtractFlow(Block b) {
        b.toBody(water[0], water[1], water[2], b.ux, b.uy, b.uz);
        for (int axis = 0; axis < 3; axis++) {
            subtract(b.count, lacking[axis], momenta[axis], b.mass, water[axis]);
            int y = (axis + 1) % 3;
            int z = (axis + 2) % 3;
            subtractMoment(b, lacking[3 + axis], momenta[3 + axis], CENTRE + y, CENTRE + z, y, z);
        }
    }

    private static void subtract(
            int count, double[] to, double[] from, double[] mass, double[] velocity) {
        for (int i = 0; i < count; i++) {
            to[i] = from[i] - mass[i] * velocity[i];
        }
    }

    /** Less m (r_G x u), one component. */
    private void subtractMoment(
            Block b, double[] to, double[] from, int centreY, int centreZ, int y, int z) {
        double[] ry = constants[centreY];
        double[] rz = constants[centreZ];
        double[] uy = water[y];
        double[] uz = water[z];
        for (int i = 0; i < b.count; i++) {
            to[i] = from[i] - b.mass[i] * (ry[i] * uz[i] - rz[i] * uy[i]);
        }
    }

    /** One row of M^-1 times momenta. */
    private void solve(int count, double[][] of, int row, double[] to) {
        if (areSymmetric) {
            solveHalf(count, of, row, to);
            return;
        }
        double[] a = inverse(row, 0);
        double[] b = inverse(row, 1);
        double[] c = inverse(row, 2);
        double[] d = inverse(row, 3);
        double[] e = inverse(row, 4);
        double[] f = inverse(row, 5);
        double[] x = of[0];
        double[] y = of[1];
        double[] z = of[2];
        double[] k = of[3];
        double[] m = of[4];
        double[] n = of[5];
        for (int i = 0; i < count; i++) {
            to[i] =
                    a[i] * x[i]
                            + b[i] * y[i]
                            + c[i] * z[i]
                            + d[i] * k[i]
                            + e[i] * m[i]
                            + f[i] * n[i];
        }
    }

    /** Of bodies that are symmetric to port and starboard half of the row are zeros. */
    private void solveHalf(int count, double[][] of, int row, double[] to) {
        int first = row % 2;
        double[] a = inverse(row, first);
        double[] b = inverse(row, first + 2);
        double[] c = inverse(row, first + 4);
        double[] x = of[first];
        double[] y = of[first + 2];
        double[] z = of[first + 4];
        for (int i = 0; i < count; i++) {
            to[i] = a[i] * x[i] + b[i] * y[i] + c[i] * z[i];
        }
    }

    /** Whether surge, heave and pitch have nothing to do with sway, roll and yaw. */
    private boolean areSymmetric(int count) {
        for (int row = 0; row < 6; row++) {
            for (int column = row + 1; column < 6; column += 2) {
                double[] element = inverse(row, column);
                for (int i = 0; i < count; i++) {
                    if (element[i] != 0) {
                        return false;
                    }
                }
            }
        }
        return true;
    }

    /** The element of the inverse at a row and a column. */
    private double[] inverse(int row, int column) {
        return inverse[6 * row + column];
    }

    private void addFlow(int count) {
        for (int axis = 0; axis < 3; axis++) {
            double[] u = water[axis];
            double[] v = velocities[axis];
            double[] vr = relative[axis];
            for (int i = 0; i < count; i++) {
                vr[i] = v[i];
                v[i] += u[i];
            }
        }
    }

    /**
     * Finds what momenta that are carried along turn the bodies by, u x p_A - v x P; they have been
     * moved. The linear momentum p_A of the water that a body carries is what the body itself, m (v
     * + w x r_G), leaves of P.
     */
    public void carry(Block b) {
        if (!isAnyHere) {
            return;
        }
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
            for (int axis = 0; axis < 3; axis++) {
                carryWater(b, axis, (axis + 1) % 3, (axis + 2) % 3);
            }
            double[][] p = lacking;
            toWorld(b, p, 0, p, 3);
            addCross(b.count, carried[0], b.uy, b.uz, p[4], p[5]);
            addCross(b.count, carried[1], b.uz, b.ux, p[5], p[3]);
            addCross(b.count, carried[2], b.ux, b.uy, p[3], p[4]);
        }
    }

    /** p_A along one of the body's axes. */
    private void carryWater(Block b, int axis, int y, int z) {
        double[] to = lacking[axis];
        double[] whole = momenta[axis];
        double[] v = velocities[axis];
        double[] wy = velocities[3 + y];
        double[] wz = velocities[3 + z];
        double[] ry = constants[CENTRE + y];
        double[] rz = constants[CENTRE + z];
        for (int i = 0; i < b.count; i++) {
            to[i] = whole[i] - b.mass[i] * (v[i] + wy[i] * rz[i] - wz[i] * ry[i]);
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
            double[] from = inWater ? relative[axis] : velocities[axis];
            System.arraycopy(from, 0, to[axis], 0, count);
        }
    }

    /** Fills the places of the bodies' centres of mass (m from the origins, world axes). */
    public void centres(Block b, double[] x, double[] y, double[] z) {
        b.toWorld(x, y, z, constants[CENTRE], constants[CENTRE + 1], constants[CENTRE + 2]);
    }
}
