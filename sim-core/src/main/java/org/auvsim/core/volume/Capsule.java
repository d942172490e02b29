package org.auvsim.core.volume;

import org.auvsim.core.description.Unit;
import org.auvsim.core.math.Mat3;
import org.auvsim.core.math.Vec3;

/**
 * A cylinder about the x axis with half a ball on each end: all points within the radius of a
 * segment of that axis, its middle at the origin.
 *
 * @param length of the cylinder (m); from tip to tip it is longer by twice the radius
 */
public record Capsule(@Unit("m") double radius, @Unit("m") double length) implements Volume {
    /**
     * A capsule of this radius and length of its cylinder (m).
     *
     * @throws IllegalArgumentException if one of them is not positive and finite
     */
    public Capsule {
        requireSize("radius", radius);
        requireSize("length", length);
    }

    private static void requireSize(String what, double size) {
        if (!(size > 0) || Double.isInfinite(size)) {
            throw new IllegalArgumentException(
                    "a capsule's " + what + " must be above 0 m and finite, but is " + size + " m");
        }
    }

    @Override
    public double boundingRadius() {
        return length / 2 + radius;
    }

    /** The cylinder's and the two half balls', each moved out by its own centre of mass. */
    @Override
    public Mat3 inertia(double mass) {
        double share = length / (length + 4 * radius / 3);
        double cylinder = mass * share;
        double balls = mass - cylinder;
        double rr = radius * radius;
        double along = cylinder * rr / 2 + balls * 0.4 * rr;
        double across =
                cylinder * (rr / 4 + length * length / 12)
                        + balls * (0.4 * rr + length * length / 4 + 0.375 * length * radius);
        return Mat3.diagonal(along, across, across);
    }

    @Override
    public double reach(Pose pose, double nx, double ny, double nz) {
        return length / 2 * Math.abs(pose.alongX(nx, ny, nz)) + radius;
    }

    @Override
    public boolean contains(Vec3 point) {
        double beyond = Math.max(0, Math.abs(point.x()) - length / 2);
        return beyond * beyond + point.y() * point.y() + point.z() * point.z() <= radius * radius;
    }

    @Override
    public double distance(Ray ray) {
        double ends = Math.min(ray.ball(-length / 2, radius), ray.ball(length / 2, radius));
        return Math.min(ends, cylinder(ray));
    }

    /** Where a ray goes through the side of the cylinder, or 0 from inside of it. */
    private double cylinder(Ray ray) {
        Vec3 p = ray.from();
        Vec3 d = ray.direction();
        double outside = p.y() * p.y() + p.z() * p.z() - radius * radius;
        if (outside <= 0) {
            return Math.abs(p.x()) <= length / 2 ? 0 : Ray.MISS;
        }
        double a = d.y() * d.y() + d.z() * d.z();
        double b = p.y() * d.y() + p.z() * d.z();
        double square = b * b - a * outside;
        if (!(b < 0) || square < 0) {
            return Ray.MISS;
        }
        double t = outside / (Math.sqrt(square) - b);
        return Math.abs(p.x() + t * d.x()) <= length / 2 ? ray.within(t) : Ray.MISS;
    }
}
