package org.auvsim.core.volume;

import org.auvsim.core.description.Unit;
import org.auvsim.core.math.Mat3;
import org.auvsim.core.math.Vec3;

/** A cuboid about the origin with edges along the body's axes. */
public record Box(@Unit("m") Vec3 size) implements Volume {
    /**
     * A cuboid with edges of these lengths (m) along x, y and z.
     *
     * @throws IllegalArgumentException if an edge is not positive and finite
     */
    public Box {
        if (!size.isFinite() || !(size.x() > 0 && size.y() > 0 && size.z() > 0)) {
            throw new IllegalArgumentException(
                    "a box's edges must be above 0 m and finite, but are " + size + " m");
        }
    }

    /** Half of each edge (m): the corner in the positive octant. */
    public Vec3 halfSize() {
        return size.times(0.5);
    }

    @Override
    public double boundingRadius() {
        return size.norm() / 2;
    }

    @Override
    public Mat3 inertia(double mass) {
        double xx = size.x() * size.x();
        double yy = size.y() * size.y();
        double zz = size.z() * size.z();
        double k = mass / 12;
        return Mat3.diagonal(k * (yy + zz), k * (xx + zz), k * (xx + yy));
    }

    @Override
    public double reach(Pose pose, double nx, double ny, double nz) {
        double x = size.x() * Math.abs(pose.alongX(nx, ny, nz));
        double y = size.y() * Math.abs(pose.alongY(nx, ny, nz));
        double z = size.z() * Math.abs(pose.alongZ(nx, ny, nz));
        return (x + y + z) / 2;
    }

    @Override
    public boolean contains(Vec3 point) {
        return Math.abs(point.x()) <= size.x() / 2
                && Math.abs(point.y()) <= size.y() / 2
                && Math.abs(point.z()) <= size.z() / 2;
    }

    @Override
    public double distance(Ray ray) {
        double enter = 0;
        double leave = ray.range();
        for (int axis = 0; axis < 3; axis++) {
            double half = size.component(axis) / 2;
            double p = ray.from().component(axis);
            double d = ray.direction().component(axis);
            if (d == 0) {
                if (Math.abs(p) > half) {
                    return Ray.MISS;
                }
            } else {
                enter = Math.max(enter, (Math.copySign(half, -d) - p) / d);
                leave = Math.min(leave, (Math.copySign(half, d) - p) / d);
            }
        }
        return enter <= leave ? enter : Ray.MISS;
    }
}
