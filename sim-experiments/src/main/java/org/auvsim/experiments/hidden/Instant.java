package org.auvsim.experiments.hidden;

import org.apache.commons.math3.geometry.euclidean.threed.Vector3D;

/**
 * How the body moves at a time.
 *
 * @param time since the run began (s)
 * @param position of its origin, which is its centre of mass (m, world)
 * @param velocity (m/s, world)
 * @param turning angular velocity (rad/s, body axes)
 * @param water the water's velocity at the origin (m/s, world)
 */
record Instant(
        double time,
        Vector3D position,
        Attitude attitude,
        Vector3D velocity,
        Vector3D turning,
        Vector3D water) {
    /** Numbers of a state: position, quaternion, velocity, angular velocity. */
    static final int SIZE = 13;

    static Instant of(double t, double[] y, Water water) {
        Vector3D position = vector(y, 0);
        return new Instant(
                t,
                position,
                new Attitude(y[3], y[4], y[5], y[6]).normalized(),
                vector(y, 7),
                vector(y, 10),
                water.at(position, t));
    }

    static Vector3D vector(double[] y, int from) {
        return new Vector3D(y[from], y[from + 1], y[from + 2]);
    }

    static void put(Vector3D v, double[] y, int from) {
        y[from] = v.getX();
        y[from + 1] = v.getY();
        y[from + 2] = v.getZ();
    }

    /** Velocity relative to the water (m/s, world). */
    Vector3D throughWater() {
        return velocity.subtract(water);
    }

    /** Angular velocity (rad/s, world axes). */
    Vector3D turningInWorld() {
        return attitude.toWorld(turning);
    }

    void putInto(double[] y) {
        put(position, y, 0);
        y[3] = attitude.w();
        y[4] = attitude.x();
        y[5] = attitude.y();
        y[6] = attitude.z();
        put(velocity, y, 7);
        put(turning, y, 10);
    }
}
