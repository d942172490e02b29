package org.auvsim.core.entity;

import org.auvsim.core.math.Vec3;
import org.jspecify.annotations.Nullable;

import java.util.Arrays;

/**
 * Up to {@value #SIZE} bodies while they are integrated: one array a quantity, index {@code i} for
 * the body in slot {@code slot(i)}, for {@code i < count}.
 *
 * <p>The fields are open on purpose: loops over plain arrays are what the compiler vectorises.
 * Effects read all of them and write {@code fx} to {@code tz} alone.
 */
public final class Block {
    /** The number of bodies that fit: large enough for long loops, small enough for the cache. */
    public static final int SIZE = 128;

    /** No step of a body is cut into more parts than this. */
    public static final int MOST_SUB_STEPS = 4096;

    /** Number of bodies in use. */
    public int count;

    /** The world's time (s) of the state. */
    public double time;

    /** The state: one array for each column of {@link BodyState}. */
    public final double[][] state = new double[BodyState.COLUMNS][SIZE];

    /** The derivative of the state by time, column by column. */
    public final double[][] rate = new double[BodyState.COLUMNS][SIZE];

    /** Rotation matrices, body to world: {@code rxy} is row x, column y. */
    public final double[] rxx = new double[SIZE];

    public final double[] rxy = new double[SIZE];
    public final double[] rxz = new double[SIZE];
    public final double[] ryx = new double[SIZE];
    public final double[] ryy = new double[SIZE];
    public final double[] ryz = new double[SIZE];
    public final double[] rzx = new double[SIZE];
    public final double[] rzy = new double[SIZE];
    public final double[] rzz = new double[SIZE];

    /** Velocity of the origin (m/s, world): the rate of the position, in the same arrays. */
    public final double[] vx = rate[BodyState.X];

    public final double[] vy = rate[BodyState.Y];
    public final double[] vz = rate[BodyState.Z];

    /** Angular velocity (rad/s, world). */
    public final double[] wx = new double[SIZE];

    public final double[] wy = new double[SIZE];
    public final double[] wz = new double[SIZE];

    /** Angular velocity in the body's axes (rad/s). */
    public final double[] bodyWx = new double[SIZE];

    public final double[] bodyWy = new double[SIZE];
    public final double[] bodyWz = new double[SIZE];

    /** Velocity of the water at the origin (m/s, world). */
    public final double[] ux = new double[SIZE];

    public final double[] uy = new double[SIZE];
    public final double[] uz = new double[SIZE];

    /** Mass (kg); 0 for a fixed body. */
    public final double[] mass = new double[SIZE];

    /** Inverse mass (1/kg); 0 for a fixed body. */
    public final double[] inverseMass = new double[SIZE];

    /** Inverse inertia (1/(kg m^2), body axes), elements as in {@link BodyState}. */
    public final double[][] inverseInertia = new double[BodyState.ELEMENTS][SIZE];

    /** Whether one of the bodies is fixed. */
    public boolean hasFixed;

    /** Whether the inverse inertia has been loaded, as bodies that do not turn need none. */
    public boolean hasInertia;

    /** Whether one of the bodies has products of inertia. */
    public boolean hasProducts;

    /**
     * Whether a body turns or something but a contact may turn it. If not, angular momenta are zero
     * and nothing that depends on them or changes them is computed.
     */
    public boolean turning = true;

    /** Force (N, world): the rate of the linear momentum, in the same arrays. */
    public final double[] fx = rate[BodyState.PX];

    public final double[] fy = rate[BodyState.PY];
    public final double[] fz = rate[BodyState.PZ];

    /** Torque about the origin (N m, world): the rate of the angular momentum, likewise. */
    public final double[] tx = rate[BodyState.LX];

    public final double[] ty = rate[BodyState.LY];
    public final double[] tz = rate[BodyState.LZ];

    /**
     * Forces (N, world) and torques about the origin (N m, world) of contacts: constant while the
     * bodies are integrated, and added to what else acts on them if {@link #hasContactForces}.
     */
    public final double[] contactFx = new double[SIZE];

    public final double[] contactFy = new double[SIZE];
    public final double[] contactFz = new double[SIZE];
    public final double[] contactTx = new double[SIZE];
    public final double[] contactTy = new double[SIZE];
    public final double[] contactTz = new double[SIZE];

    /** Whether the forces and torques of contacts count; loading bodies turns it off. */
    public boolean hasContactForces;

    /** Free for an effect's own use while it adds; what it left there is lost afterwards. */
    public final double[][] scratch = new double[8][SIZE];

    /** Whether one of the bodies has an inertia of its own kind, {@link BodyState#spatial}. */
    public boolean hasSpatial;

    /** What momenta carried along turn a body by (N m, world): u x p_A - v x P. */
    final double[] carriedTx = new double[SIZE];

    final double[] carriedTy = new double[SIZE];
    final double[] carriedTz = new double[SIZE];
    final @Nullable SpatialInertia[] inertia = new @Nullable SpatialInertia[SIZE];
    final double[] spatial = new double[SpatialInertia.SCRATCH];

    /** Resultants of named forces and propulsors, as {@link AppliedForces} lays them out. */
    final double[][] applied = new double[AppliedForces.COLUMNS][SIZE];

    private final int[] subSteps = new int[SIZE];
    private boolean hasSubSteps;
    private final int[] slots = new int[SIZE];
    private boolean neighbours = true;
    private double[][][] work = new double[0][][];

    /** Takes {@code count} bodies, from a slot on. */
    public void take(int firstSlot, int count) {
        this.count = count;
        hasContactForces = false;
        hasSubSteps = false;
        hasInertia = false;
        neighbours = true;
        for (int i = 0; i < count; i++) {
            slots[i] = firstSlot + i;
        }
    }

    /** Takes the bodies in the first {@code count} of these slots. */
    public void take(int[] ofSlots, int count) {
        this.count = count;
        hasContactForces = false;
        hasSubSteps = false;
        hasInertia = false;
        neighbours = false;
        System.arraycopy(ofSlots, 0, slots, 0, count);
    }

    /**
     * Into how many parts the step that an integrator has just made should have been cut for body
     * {@code i}; 1 if it is fine.
     */
    public int subSteps(int i) {
        return hasSubSteps ? subSteps[i] : 1;
    }

    /** Whether a body's step should have been cut. */
    public boolean hasSubSteps() {
        return hasSubSteps;
    }

    /** An integrator states its opinion on its step of body {@code i}. */
    public void setSubSteps(int i, int parts) {
        if (!hasSubSteps && parts > 1) {
            hasSubSteps = true;
            Arrays.fill(subSteps, 1);
        }
        subSteps[i] = parts;
    }

    /** Whether a body may turn while they are integrated. */
    public boolean turns() {
        return turning || hasContactForces;
    }

    /** The inertia of body {@code i} if it is more than mass and tensor about its origin. */
    public @Nullable SpatialInertia inertia(int i) {
        return inertia[i];
    }

    /** Slot of body {@code i}. */
    public int slot(int i) {
        return slots[i];
    }

    /** Copies a quantity of the block's bodies out of an array with a place for each slot. */
    public void gather(double[] bySlot, double[] to) {
        if (neighbours) {
            System.arraycopy(bySlot, slots[0], to, 0, count);
            return;
        }
        for (int i = 0; i < count; i++) {
            to[i] = bySlot[slots[i]];
        }
    }

    /** Copies a quantity of the block's bodies into an array with a place for each slot. */
    public void scatter(double[] from, double[] bySlot) {
        if (neighbours) {
            System.arraycopy(from, 0, bySlot, slots[0], count);
            return;
        }
        for (int i = 0; i < count; i++) {
            bySlot[slots[i]] = from[i];
        }
    }

    /** Scratch copies of the state for an integrator, kept from call to call. */
    public double[][][] work(int copies) {
        if (work.length < copies) {
            work = new double[copies][BodyState.COLUMNS][SIZE];
        }
        return work;
    }

    /** Position (m, world) of body {@code i}. */
    public Vec3 position(int i) {
        return new Vec3(state[BodyState.X][i], state[BodyState.Y][i], state[BodyState.Z][i]);
    }

    /** Velocity (m/s, world) of the origin of body {@code i}. */
    public Vec3 velocity(int i) {
        return new Vec3(vx[i], vy[i], vz[i]);
    }

    /** Angular velocity (rad/s, world) of body {@code i}. */
    public Vec3 angularVelocity(int i) {
        return new Vec3(wx[i], wy[i], wz[i]);
    }

    /** Velocity (m/s, world) of the water at the origin of body {@code i}. */
    public Vec3 waterVelocity(int i) {
        return new Vec3(ux[i], uy[i], uz[i]);
    }

    /** Turns a world vector into the axes of body {@code i}. */
    public Vec3 toBody(int i, Vec3 world) {
        return new Vec3(
                rxx[i] * world.x() + ryx[i] * world.y() + rzx[i] * world.z(),
                rxy[i] * world.x() + ryy[i] * world.y() + rzy[i] * world.z(),
                rxz[i] * world.x() + ryz[i] * world.y() + rzz[i] * world.z());
    }

    /** Turns a vector in the axes of body {@code i} into a world vector. */
    public Vec3 toWorld(int i, Vec3 body) {
        return new Vec3(
                rxx[i] * body.x() + rxy[i] * body.y() + rxz[i] * body.z(),
                ryx[i] * body.x() + ryy[i] * body.y() + ryz[i] * body.z(),
                rzx[i] * body.x() + rzy[i] * body.y() + rzz[i] * body.z());
    }

    /** Adds a force (N, world) at the origin of body {@code i}. */
    public void addForce(int i, Vec3 force) {
        fx[i] += force.x();
        fy[i] += force.y();
        fz[i] += force.z();
    }

    /** Adds a torque (N m, world) about the origin of body {@code i}. */
    public void addTorque(int i, Vec3 torque) {
        tx[i] += torque.x();
        ty[i] += torque.y();
        tz[i] += torque.z();
    }

    /** Adds the forces and torques of contacts to the others. */
    public void addContactForces() {
        add(fx, contactFx);
        add(fy, contactFy);
        add(fz, contactFz);
        add(tx, contactTx);
        add(ty, contactTy);
        add(tz, contactTz);
    }

    private void add(double[] to, double[] what) {
        for (int i = 0; i < count; i++) {
            to[i] += what[i];
        }
    }

    /** Turns vectors, one a body, from the world's axes into the bodies', in other arrays. */
    public void toBody(
            double[] toX, double[] toY, double[] toZ, double[] x, double[] y, double[] z) {
        turn(toX, rxx, x, ryx, y, rzx, z);
        turn(toY, rxy, x, ryy, y, rzy, z);
        turn(toZ, rxz, x, ryz, y, rzz, z);
    }

    /** Turns vectors, one a body, from the bodies' axes into the world's, in other arrays. */
    public void toWorld(
            double[] toX, double[] toY, double[] toZ, double[] x, double[] y, double[] z) {
        turn(toX, rxx, x, rxy, y, rxz, z);
        turn(toY, ryx, x, ryy, y, ryz, z);
        turn(toZ, rzx, x, rzy, y, rzz, z);
    }

    /** Turns vectors, one a body, from the bodies' axes into the world's and adds them. */
    public void addToWorld(
            double[] toX, double[] toY, double[] toZ, double[] x, double[] y, double[] z) {
        addTurned(toX, rxx, x, rxy, y, rxz, z);
        addTurned(toY, ryx, x, ryy, y, ryz, z);
        addTurned(toZ, rzx, x, rzy, y, rzz, z);
    }

    private void turn(
            double[] to,
            double[] rx,
            double[] x,
            double[] ry,
            double[] y,
            double[] rz,
            double[] z) {
        for (int i = 0; i < count; i++) {
            to[i] = rx[i] * x[i] + ry[i] * y[i] + rz[i] * z[i];
        }
    }

    private void addTurned(
            double[] to,
            double[] rx,
            double[] x,
            double[] ry,
            double[] y,
            double[] rz,
            double[] z) {
        for (int i = 0; i < count; i++) {
            to[i] += rx[i] * x[i] + ry[i] * y[i] + rz[i] * z[i];
        }
    }
}
