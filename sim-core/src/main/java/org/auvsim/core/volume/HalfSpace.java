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
        return reachBelow(0, pose, nx, ny, nz);
    }

    /** The reach of all that is not above the plane z = {@code top}. */
    static double reachBelow(double top, Pose pose, double nx, double ny, double nz) {
        boolean up =
                Math.abs(pose.alongX(nx, ny, nz)) <= ROUNDING
                        && Math.abs(pose.alongY(nx, ny, nz)) <= ROUNDING
                        && pose.alongZ(nx, ny, nz) > 0;
        return up ? top : Double.POSITIVE_INFINITY;
    }

    @Override
    public boolean contains(Vec3 point) {
        return point.z() <= 0;
    }

    @Override
    public double distance(Ray ray) {
        double above = ray.from().z();
        if (above <= 0) {
            return 0;
        }
        return ray.direction().z() < 0 ? ray.within(above / -ray.direction().z()) : Ray.MISS;
    }
}
