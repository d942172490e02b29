package org.auvsim.core.entity;

import org.auvsim.core.math.Exponentials;
import org.auvsim.core.math.Vec3;
import org.jspecify.annotations.Nullable;

import java.util.Arrays;

/**
 * Up to {@value #SIZE} bodies, or as many as are coupled, while they are integrated: one array a
 * quantity, index {@code i} for the body in slot {@code slot(i)}, for {@code i < count}.
 *
 * <p>The fields are open on purpose: loops over plain arrays are what the compiler vectorises.
 * Effects read all of them and write {@code fx} to {@code tz} alone.
 */
public final class Block {
    /** The number of bodies that fit: large enough for long loops, small enough for the cache. */
    public static final int SIZE = 128;

    /** No step of a body is cut into more parts than this. */
    public static final int MOST_SUB_STEPS = 4096;

    /** The number of bodies that fit into this one. */
    public final int capacity;

    /** Number of bodies in use. */
    public int count;

    /** The world's time (s) of the state. */
    public double time;

    /** The state: one array for each column of {@link BodyState}. */
    public final double[][] state;

    /** The derivative of the state by time, column by column. */
    public final double[][] rate;

    /** Rotation matrices, body to world: {@code rxy} is row x, column y. */
    public final double[] rxx;

    public final double[] rxy;
    public final double[] rxz;
    public final double[] ryx;
    public final double[] ryy;
    public final double[] ryz;
    public final double[] rzx;
    public final double[] rzy;
    public final double[] rzz;

    /** Velocity of the origin (m/s, world): the rate of the position, in the same arrays. */
    public final double[] vx;

    public final double[] vy;
    public final double[] vz;

    /** Angular velocity (rad/s, world). */
    public final double[] wx;

    public final double[] wy;
    public final double[] wz;

    /** Angular velocity in the body's axes (rad/s). */
    public final double[] bodyWx;

    public final double[] bodyWy;
    public final double[] bodyWz;

    /** Velocities relative to the water in body axes, then in the world's. */
    private final double[][] relative;

    private boolean hasRelative;

    /** Velocity of the water at the origin (m/s, world). */
    public final double[] ux;

    public final double[] uy;
    public final double[] uz;

    /**
     * Derivatives of the water's velocity at the origin, of meaning only if {@link #hasFlow}: by
     * time (m/s^2) at 0 to 2, by place (1/s) at {@code 3 + 3 * row + column} for the change of
     * component {@code row} along axis {@code column}.
     */
    public final double[][] flow;

    /** Whether there are currents. */
    public boolean hasWater;

    /** Whether the water moves unevenly or in time. */
    public boolean hasFlow;

    /** By how much (m) waves raise the water's surface over the origin. */
    public final double[] elevation;

    /** Mass (kg); 0 for a fixed body. */
    public final double[] mass;

    /** Inverse mass (1/kg); 0 for a fixed body. */
    public final double[] inverseMass;

    /** Inverse inertia (1/(kg m^2), body axes), elements as in {@link BodyState}. */
    public final double[][] inverseInertia;

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
    public final double[] fx;

    public final double[] fy;
    public final double[] fz;

    /** Torque about the origin (N m, world): the rate of the angular momentum, likewise. */
    public final double[] tx;

    public final double[] ty;
    public final double[] tz;

    /**
     * Forces (N, world) and torques about the origin (N m, world) of contacts: constant while the
     * bodies are integrated, and added to what else acts on them if {@link #hasContactForces}.
     */
    public final double[] contactFx;

    public final double[] contactFy;
    public final double[] contactFz;
    public final double[] contactTx;
    public final double[] contactTy;
    public final double[] contactTz;

    /** Whether the forces and torques of contacts count; loading bodies turns it off. */
    public boolean hasContactForces;

    /** Whether one of the torques of contacts is not zero. */
    public boolean hasContactTorques;

    /** Free for an effect's own use while it adds; what it left there is lost afterwards. */
    public final double[][] scratch;

    /** Free for an actuator's own use while it adds: force, then torque, in the body's axes. */
    public final double[] push = new double[6];

    /** What the timed actuators of a body push. */
    final double[] timedPush = new double[6];

    /** For actuators that follow with a lag, which is often the same of all bodies. */
    public final Exponentials exponentials = new Exponentials();

    /** Whether one of the bodies has an inertia of its own kind, {@link BodyState#spatial}. */
    public boolean hasSpatial;

    /** What momenta carried along turn a body by (N m, world): u x p_A - v x P. */
    final double[] carriedTx;

    final double[] carriedTy;
    final double[] carriedTz;
    final @Nullable SpatialInertia[] inertia;
    final double[] spatial = new double[SpatialInertia.SCRATCH];

    /** Resultants of named forces and propulsors, as {@link AppliedForces} lays them out. */
    final double[][] applied;

    private @Nullable SpatialBlock spatialBlock;
    private final int[] subSteps;
    private boolean hasSubSteps;
    private final BlockSlots slots;
    private double[][][] work = new double[0][][];

    /** A block of the usual size. */
    public Block() {
        this(SIZE);
    }

    /** A block for up to {@code capacity} bodies: larger ones hold bodies that are coupled. */
    public Block(int capacity) {
        this.capacity = capacity;
        state = new double[BodyState.COLUMNS][capacity];
        rate = new double[BodyState.COLUMNS][capacity];
        rxx = new double[capacity];
        rxy = new double[capacity];
        rxz = new double[capacity];
        ryx = new double[capacity];
        ryy = new double[capacity];
        ryz = new double[capacity];
        rzx = new double[capacity];
        rzy = new double[capacity];
        rzz = new double[capacity];
        vx = rate[BodyState.X];
        vy = rate[BodyState.Y];
        vz = rate[BodyState.Z];
        wx = new double[capacity];
        wy = new double[capacity];
        wz = new double[capacity];
        bodyWx = new double[capacity];
        bodyWy = new double[capacity];
        bodyWz = new double[capacity];
        relative = new double[6][capacity];
        ux = new double[capacity];
        uy = new double[capacity];
        uz = new double[capacity];
        flow = new double[12][capacity];
        elevation = new double[capacity];
        mass = new double[capacity];
        inverseMass = new double[capacity];
        inverseInertia = new double[BodyState.ELEMENTS][capacity];
        fx = rate[BodyState.PX];
        fy = rate[BodyState.PY];
        fz = rate[BodyState.PZ];
        tx = rate[BodyState.LX];
        ty = rate[BodyState.LY];
        tz = rate[BodyState.LZ];
        contactFx = new double[capacity];
        contactFy = new double[capacity];
        contactFz = new double[capacity];
        contactTx = new double[capacity];
        contactTy = new double[capacity];
        contactTz = new double[capacity];
        scratch = new double[16][capacity];
        carriedTx = new double[capacity];
        carriedTy = new double[capacity];
        carriedTz = new double[capacity];
        inertia = new @Nullable SpatialInertia[capacity];
        applied = new double[AppliedForces.COLUMNS][capacity];
        subSteps = new int[capacity];
        slots = new BlockSlots(capacity);
    }

    /** Takes {@code count} bodies, from a slot on. */
    public void take(int firstSlot, int count) {
        slots.take(firstSlot, count);
        begin(count);
    }

    /** Takes the bodies in the first {@code count} of these slots. */
    public void take(int[] ofSlots, int count) {
        slots.take(ofSlots, count);
        begin(count);
    }

    private void begin(int newCount) {
        count = newCount;
        hasContactForces = false;
        hasContactTorques = false;
        hasSubSteps = false;
        hasInertia = false;
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
        return turning || hasContactTorques;
    }

    /** The inertia of body {@code i} if it is more than mass and tensor about its origin. */
    public @Nullable SpatialInertia inertia(int i) {
        return inertia[i];
    }

    /** What is computed for all bodies with an inertia of their own kind together. */
    public SpatialBlock spatial() {
        if (spatialBlock == null) {
            spatialBlock = new SpatialBlock(capacity);
        }
        return spatialBlock;
    }

    /** Slot of body {@code i}. */
    public int slot(int i) {
        return slots.get(i);
    }

    /** Where in the block the body in a slot is; -1 if it is not there. */
    public int indexOf(int slot) {
        return slots.indexOf(slot);
    }

    /** Where the bodies in these slots are; an empty array if one of them is missing. */
    int[] find(int[] ofSlots) {
        return slots.find(ofSlots);
    }

    /** Copies a quantity of the block's bodies out of an array with a place for each slot. */
    public void gather(double[] bySlot, double[] to) {
        slots.gather(bySlot, to);
    }

    /** Copies a quantity of the block's bodies into an array with a place for each slot. */
    public void scatter(double[] from, double[] bySlot) {
        slots.scatter(from, bySlot);
    }

    /** Scratch copies of the state for an integrator, kept from call to call. */
    public double[][][] work(int copies) {
        if (work.length < copies) {
            work = new double[copies][BodyState.COLUMNS][capacity];
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

    /** Angular velocity (rad/s) of body {@code i} in its own axes. */
    public Vec3 bodyAngularVelocity(int i) {
        return new Vec3(bodyWx[i], bodyWy[i], bodyWz[i]);
    }

    /** Velocity (m/s, world) of the water at the origin of body {@code i}. */
    public Vec3 waterVelocity(int i) {
        return new Vec3(ux[i], uy[i], uz[i]);
    }

    /**
     * Velocities of the origins relative to the water, in the bodies' axes (m/s): three arrays,
     * computed when they are first asked for in an evaluation.
     */
    public double[][] relativeVelocities() {
        if (!hasRelative) {
            if (hasSpatial && spatial().areAllHere()) {
                spatial().relative(count, hasWater, relative);
            } else {
                Loops.subtract(count, relative[3], vx, ux);
                Loops.subtract(count, relative[4], vy, uy);
                Loops.subtract(count, relative[5], vz, uz);
                toBody(
                        relative[0],
                        relative[1],
                        relative[2],
                        relative[3],
                        relative[4],
                        relative[5]);
            }
            hasRelative = true;
        }
        return relative;
    }

    /** States that velocities have changed. */
    public void moved() {
        hasRelative = false;
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

    /** Adds a force (N) and a torque about the origin (N m), in the axes of body {@code i}. */
    public void addFromBody(
            int i, double bx, double by, double bz, double mx, double my, double mz) {
        fx[i] += rxx[i] * bx + rxy[i] * by + rxz[i] * bz;
        fy[i] += ryx[i] * bx + ryy[i] * by + ryz[i] * bz;
        fz[i] += rzx[i] * bx + rzy[i] * by + rzz[i] * bz;
        tx[i] += rxx[i] * mx + rxy[i] * my + rxz[i] * mz;
        ty[i] += ryx[i] * mx + ryy[i] * my + ryz[i] * mz;
        tz[i] += rzx[i] * mx + rzy[i] * my + rzz[i] * mz;
    }

    /**
     * The same.
     *
     * @param push force, then torque
     */
    public void addFromBody(int i, double[] push) {
        addFromBody(i, push[0], push[1], push[2], push[3], push[4], push[5]);
    }

    /** Adds the forces and torques of contacts to the others. */
    public void addContactForces() {
        Loops.add(count, fx, contactFx);
        Loops.add(count, fy, contactFy);
        Loops.add(count, fz, contactFz);
        Loops.add(count, tx, contactTx);
        Loops.add(count, ty, contactTy);
        Loops.add(count, tz, contactTz);
    }

    /** Turns vectors, one a body, from the world's axes into the bodies', in other arrays. */
    public void toBody(
            double[] toX, double[] toY, double[] toZ, double[] x, double[] y, double[] z) {
        Loops.turn(count, toX, rxx, x, ryx, y, rzx, z);
        Loops.turn(count, toY, rxy, x, ryy, y, rzy, z);
        Loops.turn(count, toZ, rxz, x, ryz, y, rzz, z);
    }

    /** Turns vectors, one a body, from the bodies' axes into the world's, in other arrays. */
    public void toWorld(
            double[] toX, double[] toY, double[] toZ, double[] x, double[] y, double[] z) {
        Loops.turn(count, toX, rxx, x, rxy, y, rxz, z);
        Loops.turn(count, toY, ryx, x, ryy, y, ryz, z);
        Loops.turn(count, toZ, rzx, x, rzy, y, rzz, z);
    }

    /** Turns vectors, one a body, from the bodies' axes into the world's and adds them. */
    public void addToWorld(
            double[] toX, double[] toY, double[] toZ, double[] x, double[] y, double[] z) {
        Loops.addTurned(count, toX, rxx, x, rxy, y, rxz, z);
        Loops.addTurned(count, toY, ryx, x, ryy, y, ryz, z);
        Loops.addTurned(count, toZ, rzx, x, rzy, y, rzz, z);
    }
}
