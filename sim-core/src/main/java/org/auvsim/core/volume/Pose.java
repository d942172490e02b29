package org.auvsim.core.volume;

import org.auvsim.core.math.Quat;
import org.auvsim.core.math.Vec3;

/**
 * Where a volume is: position of its origin (m, world) and orientation (unit quaternion, body to
 * world). Mutable on purpose: the search for collisions fills two of them millions of times.
 */
public final class Pose {
    public double x;
    public double y;
    public double z;
    public double qw = 1;
    public double qx;
    public double qy;
    public double qz;

    /** A pose at {@code position}, turned by {@code orientation}. */
    public static Pose of(Vec3 position, Quat orientation) {
        Pose pose = new Pose();
        pose.set(position, orientation);
        return pose;
    }

    /** Moves this pose. */
    public void set(Vec3 position, Quat orientation) {
        x = position.x();
        y = position.y();
        z = position.z();
        qw = orientation.w();
        qx = orientation.x();
        qy = orientation.y();
        qz = orientation.z();
    }

    /** The origin (m, world). */
    public Vec3 position() {
        return new Vec3(x, y, z);
    }

    /** The orientation, body to world. */
    public Quat orientation() {
        return new Quat(qw, qx, qy, qz);
    }

    /** The component of a world vector along the volume's x axis. */
    double alongX(double vx, double vy, double vz) {
        return (1 - 2 * (qy * qy + qz * qz)) * vx
                + 2 * (qx * qy + qw * qz) * vy
                + 2 * (qx * qz - qw * qy) * vz;
    }

    /** The component of a world vector along the volume's y axis. */
    double alongY(double vx, double vy, double vz) {
        return 2 * (qx * qy - qw * qz) * vx
                + (1 - 2 * (qx * qx + qz * qz)) * vy
                + 2 * (qy * qz + qw * qx) * vz;
    }

    /** The component of a world vector along the volume's z axis. */
    double alongZ(double vx, double vy, double vz) {
        return 2 * (qx * qz + qw * qy) * vx
                + 2 * (qy * qz - qw * qx) * vy
                + (1 - 2 * (qx * qx + qy * qy)) * vz;
    }

    /** Writes this pose as seen from another, in that one's coordinates. */
    void seenFrom(Pose other, Pose to) {
        double dx = x - other.x;
        double dy = y - other.y;
        double dz = z - other.z;
        to.x = other.alongX(dx, dy, dz);
        to.y = other.alongY(dx, dy, dz);
        to.z = other.alongZ(dx, dy, dz);
        to.qw = other.qw * qw + other.qx * qx + other.qy * qy + other.qz * qz;
        to.qx = other.qw * qx - other.qx * qw - other.qy * qz + other.qz * qy;
        to.qy = other.qw * qy + other.qx * qz - other.qy * qw - other.qz * qx;
        to.qz = other.qw * qz - other.qx * qy + other.qy * qx - other.qz * qw;
    }

    /** Component {@code k} (world) of a vector in the volume's coordinates. */
    double toWorld(int k, double vx, double vy, double vz) {
        return Turn.component(k, vx, vy, vz, qw, qx, qy, qz);
    }
}
