package org.auvsim.core.entity;

import org.auvsim.core.math.Vec3;

/**
 * Up to {@value #SIZE} neighbouring bodies while they are integrated: one array a quantity, index
 * {@code i} for the body in slot {@code first + i}, for {@code i < count}.
 *
 * <p>The fields are open on purpose: loops over plain arrays are what the compiler vectorises.
 * Effects read all of them and write {@code fx} to {@code tz} alone.
 */
public final class Block {
    /** The number of bodies that fit: small enough for the first-level cache. */
    public static final int SIZE = 64;

    /** Slot of the first body. */
    public int first;

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

    /** Velocity of the origin (m/s, world). */
    public final double[] vx = new double[SIZE];

    public final double[] vy = new double[SIZE];
    public final double[] vz = new double[SIZE];

    /** Angular velocity (rad/s, world). */
    public final double[] wx = new double[SIZE];

    public final double[] wy = new double[SIZE];
    public final double[] wz = new double[SIZE];

    /** Velocity of the water at the origin (m/s, world). */
    public final double[] ux = new double[SIZE];

    public final double[] uy = new double[SIZE];
    public final double[] uz = new double[SIZE];

    /** Mass (kg). */
    public final double[] mass = new double[SIZE];

    /** Force (N, world). */
    public final double[] fx = new double[SIZE];

    public final double[] fy = new double[SIZE];
    public final double[] fz = new double[SIZE];

    /** Torque about the origin (N m, world). */
    public final double[] tx = new double[SIZE];

    public final double[] ty = new double[SIZE];
    public final double[] tz = new double[SIZE];

    /** Free for an effect's own use while it adds; what it left there is lost afterwards. */
    public final double[] scratchX = new double[SIZE];

    public final double[] scratchY = new double[SIZE];
    public final double[] scratchZ = new double[SIZE];

    private double[][][] work = new double[0][][];

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
}
