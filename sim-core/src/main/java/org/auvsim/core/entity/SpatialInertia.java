package org.auvsim.core.entity;

import org.auvsim.core.math.Mat3;
import org.auvsim.core.math.Quat;
import org.auvsim.core.math.Vec3;
import org.jspecify.annotations.Nullable;

import java.util.List;

/**
 * The inertia of a body that is more than mass and tensor about its origin: with its centre of mass
 * elsewhere, with added mass, or on a mount (Fossen 2021, chapters 3 and 6). The momenta hold what
 * body and carried water have:
 *
 * <pre>(R^T P, R^T L) = MRB nu + MA (nu - nu_c)    dL/dt = tau - v x P + u x p_A</pre>
 *
 * <p>nu is the velocity in body axes, nu_c = (R^T u, 0) that of the water, p_A the linear part of R
 * MA (nu - nu_c). On a mount with the free directions C (world axes) the state holds C^T of these
 * momenta, and nu = C (C^T M C)^-1 C^T (...).
 *
 * <p>Vectors and matrices of a computation stand in one array, the caller's, at the places below.
 */
public final class SpatialInertia {
    /** Size of the array that a computation needs. */
    public static final int SCRATCH = 132;

    /** Rotation matrix, body to world, row by row. */
    private static final int TURN = 0;

    /** Momenta P, L (world), then velocity of the water (world). */
    private static final int MOMENTA = 9;

    private static final int WATER = 15;

    /** Results: velocities in world and body axes, momentum of the water, whole P (world). */
    private static final int VELOCITIES = 18;

    private static final int BODY_VELOCITIES = 24;
    private static final int WATER_MOMENTUM = 30;
    private static final int LINEAR_MOMENTUM = 33;

    /** Between: momenta and water in body axes, free directions in body axes, C^T M C. */
    private static final int BODY_MOMENTA = 36;

    private static final int BODY_WATER = 42;
    private static final int RELATIVE = 45;
    private static final int SPEEDS = 51;
    private static final int FREE = 57;
    private static final int REDUCED = 93;

    private final Vec3 centreOfMass;
    final double[] whole;
    final double[] inverse;
    final double[] added;
    private final boolean hasAdded;

    /** What its mount leaves; empty without one. */
    final @Nullable FreeDirections free;

    SpatialInertia(MassProperties mass, Vec3 centreOfMass, double[] added, List<Mount> mount) {
        this.centreOfMass = centreOfMass;
        this.added = added;
        whole =
                SpatialMatrix.sum(
                        SpatialMatrix.rigid(mass.mass(), centreOfMass, mass.inertia()), added);
        inverse = SpatialMatrix.inverse(whole);
        boolean any = false;
        for (double element : added) {
            any |= element != 0;
        }
        hasAdded = any;
        free = mount.isEmpty() ? null : new FreeDirections(mount.getFirst());
    }

    /** Centre of mass (m, body). */
    public Vec3 centreOfMass() {
        return centreOfMass;
    }

    /** Whether the water's velocity counts. */
    boolean hasAddedMass() {
        return hasAdded;
    }

    /** Fills the velocities of body {@code i}; rotation matrix and water velocity are there. */
    public void move(Block b, int i) {
        double[] s = b.spatial;
        load(b, i, s);
        velocities(s);
        carried(s);
        b.vx[i] = s[VELOCITIES];
        b.vy[i] = s[VELOCITIES + 1];
        b.vz[i] = s[VELOCITIES + 2];
        b.wx[i] = s[VELOCITIES + 3];
        b.wy[i] = s[VELOCITIES + 4];
        b.wz[i] = s[VELOCITIES + 5];
        b.bodyWx[i] = s[BODY_VELOCITIES + 3];
        b.bodyWy[i] = s[BODY_VELOCITIES + 4];
        b.bodyWz[i] = s[BODY_VELOCITIES + 5];
        b.carriedTx[i] = crossX(s, WATER, WATER_MOMENTUM) - crossX(s, VELOCITIES, LINEAR_MOMENTUM);
        b.carriedTy[i] = crossY(s, WATER, WATER_MOMENTUM) - crossY(s, VELOCITIES, LINEAR_MOMENTUM);
        b.carriedTz[i] = crossZ(s, WATER, WATER_MOMENTUM) - crossZ(s, VELOCITIES, LINEAR_MOMENTUM);
    }

    /** Completes force and torque of body {@code i}, and keeps them to its free directions. */
    public void complete(Block b, int i) {
        b.tx[i] += b.carriedTx[i];
        b.ty[i] += b.carriedTy[i];
        b.tz[i] += b.carriedTz[i];
        if (free != null) {
            keepFree(free, b, i);
        }
    }

    /**
     * Adds what the carried water exerts on body {@code i} since the flow about it is uneven: MA
     * ((u - v) . grad) u at the origin (Auton, Hunt &amp; Prud'homme 1988).
     */
    public void meetFlow(Block b, int i) {
        if (!hasAdded) {
            return;
        }
        double x = b.ux[i] - b.vx[i];
        double y = b.uy[i] - b.vy[i];
        double z = b.uz[i] - b.vz[i];
        double[] s = b.spatial;
        load(b, i, s);
        for (int row = 0; row < 3; row++) {
            int g = 3 + 3 * row;
            s[WATER + row] = b.flow[g][i] * x + b.flow[g + 1][i] * y + b.flow[g + 2][i] * z;
        }
        toBody(s, WATER, RELATIVE);
        for (int c = 3; c < 6; c++) {
            s[RELATIVE + c] = 0;
        }
        multiply(added, s, RELATIVE, SPEEDS, 6);
        toWorld(s, SPEEDS, VELOCITIES);
        toWorld(s, SPEEDS + 3, VELOCITIES + 3);
        b.fx[i] += s[VELOCITIES];
        b.fy[i] += s[VELOCITIES + 1];
        b.fz[i] += s[VELOCITIES + 2];
        b.tx[i] += s[VELOCITIES + 3];
        b.ty[i] += s[VELOCITIES + 4];
        b.tz[i] += s[VELOCITIES + 5];
    }

    private static double crossX(double[] s, int a, int b) {
        return s[a + 1] * s[b + 2] - s[a + 2] * s[b + 1];
    }

    private static double crossY(double[] s, int a, int b) {
        return s[a + 2] * s[b] - s[a] * s[b + 2];
    }

    private static double crossZ(double[] s, int a, int b) {
        return s[a] * s[b + 1] - s[a + 1] * s[b];
    }

    private static void keepFree(FreeDirections free, Block b, int i) {
        double[] s = b.spatial;
        for (int c = 0; c < 6; c++) {
            s[SPEEDS + c] = b.rate[BodyState.PX + c][i];
        }
        free.keep(s, SPEEDS, RELATIVE);
        for (int c = 0; c < 6; c++) {
            b.rate[BodyState.PX + c][i] = s[SPEEDS + c];
        }
    }

    private static void load(Block b, int i, double[] s) {
        s[TURN] = b.rxx[i];
        s[TURN + 1] = b.rxy[i];
        s[TURN + 2] = b.rxz[i];
        s[TURN + 3] = b.ryx[i];
        s[TURN + 4] = b.ryy[i];
        s[TURN + 5] = b.ryz[i];
        s[TURN + 6] = b.rzx[i];
        s[TURN + 7] = b.rzy[i];
        s[TURN + 8] = b.rzz[i];
        for (int c = 0; c < 6; c++) {
            s[MOMENTA + c] = b.state[BodyState.PX + c][i];
        }
        s[WATER] = b.ux[i];
        s[WATER + 1] = b.uy[i];
        s[WATER + 2] = b.uz[i];
    }

    private void velocities(double[] s) {
        toBody(s, WATER, BODY_WATER);
        toBody(s, MOMENTA, BODY_MOMENTA);
        toBody(s, MOMENTA + 3, BODY_MOMENTA + 3);
        if (hasAdded) {
            for (int row = 0; row < 6; row++) {
                for (int c = 0; c < 3; c++) {
                    s[BODY_MOMENTA + row] += added[6 * row + c] * s[BODY_WATER + c];
                }
            }
        }
        solve(s);
    }

    /** Fills the carried water's momentum, and the whole of both. */
    private void carried(double[] s) {
        waterMomentum(s);
        if (free != null) {
            wholeMomentum(s);
        } else {
            System.arraycopy(s, MOMENTA, s, LINEAR_MOMENTUM, 3);
        }
    }

    /** From momenta in body axes, that of the water's flow included, to velocities in both axes. */
    private void solve(double[] s) {
        if (free != null) {
            solve(free, s);
            return;
        }
        multiply(inverse, s, BODY_MOMENTA, BODY_VELOCITIES, 6);
        toWorld(s, BODY_VELOCITIES, VELOCITIES);
        toWorld(s, BODY_VELOCITIES + 3, VELOCITIES + 3);
    }

    private void solve(FreeDirections free, double[] s) {
        int n = free.count();
        for (int k = 0; k < n; k++) {
            System.arraycopy(free.get(k), 0, s, RELATIVE, 6);
            toBody(s, RELATIVE, FREE + 6 * k);
            toBody(s, RELATIVE + 3, FREE + 6 * k + 3);
        }
        for (int k = 0; k < n; k++) {
            multiply(whole, s, FREE + 6 * k, RELATIVE, 6);
            for (int j = 0; j < n; j++) {
                s[REDUCED + 6 * j + k] = dot(s, FREE + 6 * j, RELATIVE);
            }
            s[SPEEDS + k] = dot(s, FREE + 6 * k, BODY_MOMENTA);
        }
        SpatialMatrix.factor(s, REDUCED, n);
        SpatialMatrix.solve(s, REDUCED, n, s, SPEEDS);
        for (int c = 0; c < 6; c++) {
            double inBody = 0;
            double inWorld = 0;
            for (int k = 0; k < n; k++) {
                inBody += s[FREE + 6 * k + c] * s[SPEEDS + k];
                inWorld += free.get(k)[c] * s[SPEEDS + k];
            }
            s[BODY_VELOCITIES + c] = inBody;
            s[VELOCITIES + c] = inWorld;
        }
    }

    private void waterMomentum(double[] s) {
        if (hasAdded) {
            System.arraycopy(s, BODY_VELOCITIES, s, RELATIVE, 6);
            for (int c = 0; c < 3; c++) {
                s[RELATIVE + c] -= s[BODY_WATER + c];
            }
            multiply(added, s, RELATIVE, SPEEDS, 3);
            toWorld(s, SPEEDS, WATER_MOMENTUM);
        } else {
            for (int c = 0; c < 3; c++) {
                s[WATER_MOMENTUM + c] = 0;
            }
        }
    }

    /** The linear momentum with what the mount has taken. */
    private void wholeMomentum(double[] s) {
        multiply(whole, s, BODY_VELOCITIES, SPEEDS, 3);
        for (int row = 0; row < 3; row++) {
            for (int c = 0; c < 3; c++) {
                s[SPEEDS + row] -= added[6 * row + c] * s[BODY_WATER + c];
            }
        }
        toWorld(s, SPEEDS, LINEAR_MOMENTUM);
    }

    private static double dot(double[] s, int a, int b) {
        double sum = 0;
        for (int c = 0; c < 6; c++) {
            sum += s[a + c] * s[b + c];
        }
        return sum;
    }

    private static void multiply(double[] matrix, double[] s, int from, int to, int rows) {
        for (int row = 0; row < rows; row++) {
            double sum = 0;
            for (int c = 0; c < 6; c++) {
                sum += matrix[6 * row + c] * s[from + c];
            }
            s[to + row] = sum;
        }
    }

    private static void toBody(double[] s, int from, int to) {
        double x = s[from];
        double y = s[from + 1];
        double z = s[from + 2];
        for (int c = 0; c < 3; c++) {
            s[to + c] = s[TURN + c] * x + s[TURN + 3 + c] * y + s[TURN + 6 + c] * z;
        }
    }

    private static void toWorld(double[] s, int from, int to) {
        double x = s[from];
        double y = s[from + 1];
        double z = s[from + 2];
        for (int row = 0; row < 3; row++) {
            s[to + row] =
                    s[TURN + 3 * row] * x + s[TURN + 3 * row + 1] * y + s[TURN + 3 * row + 2] * z;
        }
    }

    private static void put(double[] s, int at, Vec3 v) {
        s[at] = v.x();
        s[at + 1] = v.y();
        s[at + 2] = v.z();
    }

    private static Vec3 get(double[] s, int at) {
        return new Vec3(s[at], s[at + 1], s[at + 2]);
    }

    private static void turn(double[] s, Quat orientation) {
        Mat3 r = orientation.toMatrix();
        put(s, TURN, new Vec3(r.xx(), r.xy(), r.xz()));
        put(s, TURN + 3, new Vec3(r.yx(), r.yy(), r.yz()));
        put(s, TURN + 6, new Vec3(r.zx(), r.zy(), r.zz()));
    }

    /** What a computation needs: without a mount, nothing of free directions. */
    private double[] scratch() {
        return new double[free == null ? FREE : SCRATCH];
    }

    /** How a body with these momenta moves in water of a velocity (m/s, world). */
    Twist twist(MovementState state, Vec3 water) {
        double[] s = scratch();
        turn(s, state.orientation());
        put(s, MOMENTA, state.linearMomentum());
        put(s, MOMENTA + 3, state.angularMomentum());
        put(s, WATER, water);
        velocities(s);
        return new Twist(get(s, VELOCITIES), get(s, VELOCITIES + 3));
    }

    /** Linear and angular momentum of a body that moves so. */
    Vec3[] momenta(Twist twist, Quat orientation, Vec3 water) {
        double[] s = scratch();
        turn(s, orientation);
        put(s, VELOCITIES, twist.velocity());
        put(s, VELOCITIES + 3, twist.angularVelocity());
        if (free != null) {
            free.keep(s, VELOCITIES, RELATIVE);
        }
        toBody(s, VELOCITIES, BODY_VELOCITIES);
        toBody(s, VELOCITIES + 3, BODY_VELOCITIES + 3);
        put(s, WATER, water);
        toBody(s, WATER, BODY_WATER);
        multiply(whole, s, BODY_VELOCITIES, BODY_MOMENTA, 6);
        for (int row = 0; row < 6; row++) {
            for (int c = 0; c < 3; c++) {
                s[BODY_MOMENTA + row] -= added[6 * row + c] * s[BODY_WATER + c];
            }
        }
        toWorld(s, BODY_MOMENTA, MOMENTA);
        toWorld(s, BODY_MOMENTA + 3, MOMENTA + 3);
        if (free != null) {
            free.keep(s, MOMENTA, RELATIVE);
        }
        return new Vec3[] {get(s, MOMENTA), get(s, MOMENTA + 3)};
    }

    /** What of a linear momentum the mount leaves. */
    Vec3 freeLinear(Vec3 momentum) {
        return projected(momentum, 0);
    }

    /** What of an angular momentum the mount leaves. */
    Vec3 freeAngular(Vec3 momentum) {
        return projected(momentum, 3);
    }

    private Vec3 projected(Vec3 momentum, int at) {
        if (free == null) {
            return momentum;
        }
        double[] s = scratch();
        put(s, SPEEDS + at, momentum);
        free.keep(s, SPEEDS, RELATIVE);
        return get(s, SPEEDS + at);
    }

    /** Writes the inverse of the inertia in world axes, 36 numbers; what is held has zeros. */
    void inverse(Quat orientation, double[] to, int at) {
        double[] s = scratch();
        turn(s, orientation);
        for (int column = 0; column < 6; column++) {
            for (int c = 0; c < 6; c++) {
                s[MOMENTA + c] = c == column ? 1 : 0;
            }
            toBody(s, MOMENTA, BODY_MOMENTA);
            toBody(s, MOMENTA + 3, BODY_MOMENTA + 3);
            solve(s);
            for (int row = 0; row < 6; row++) {
                to[at + 6 * row + column] = s[VELOCITIES + row];
            }
        }
    }
}
