package org.auvsim.core.volume;

import org.auvsim.core.math.Mat3;
import org.auvsim.core.math.Vec3;

/** All that is not above the plane z = 0 of the body: flat ground, or a wall. For fixed objects. */
public record HalfSpace() implements Volume {
    /** A direction is that of the plane's normal if its sine is no more. */
    private static final double ROUNDING = 0x1p-50;

    @Override
    public double boundingRadius() {
        return Double.POSITIVE_INFINITY;
    }

    @Override
    public Mat3 inertia(double mass) {
        throw new IllegalArgumentException(
                "a half-space has no mass: make the object fixed and leave its mass out");
    }

    @Override
    public double reach(Pose pose, double nx, double ny, double nz) {
        boolean up =
                Math.abs(pose.alongX(nx, ny, nz)) <= ROUNDING
                        && Math.abs(pose.alongY(nx, ny, nz)) <= ROUNDING
                        && pose.alongZ(nx, ny, nz) > 0;
        return up ? 0 : Double.POSITIVE_INFINITY;
    }

    @Override
    public boolean contains(Vec3 point) {
        return point.z() <= 0;
    }

    @Override
    public void bounds(Pose pose, double[] to, int at) {
        Bounds.writeAll(to, at);
        // Only a plane that lies exactly along two of the world's axes bounds it at all.
        double nx = 2 * (pose.qx * pose.qz + pose.qw * pose.qy);
        double ny = 2 * (pose.qy * pose.qz - pose.qw * pose.qx);
        double nz = 1 - 2 * (pose.qx * pose.qx + pose.qy * pose.qy);
        cut(nx, ny, nz, pose.x, to, at);
        cut(ny, nz, nx, pose.y, to, at + 1);
        cut(nz, nx, ny, pose.z, to, at + 2);
    }

    private static void cut(double n, double m, double k, double place, double[] to, int at) {
        if (m == 0 && k == 0) {
            to[n > 0 ? at + 3 : at] = place;
        }
    }
}
