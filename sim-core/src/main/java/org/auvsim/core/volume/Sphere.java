package org.auvsim.core.volume;

import org.auvsim.core.description.Unit;
import org.auvsim.core.math.Mat3;
import org.auvsim.core.math.Vec3;

/** A ball about the origin. */
public record Sphere(@Unit("m") double radius) implements Volume {
    /**
     * A ball of this radius (m).
     *
     * @throws IllegalArgumentException if the radius is not positive and finite
     */
    public Sphere {
        if (!(radius > 0) || Double.isInfinite(radius)) {
            throw new IllegalArgumentException(
                    "a sphere's radius must be above 0 m and finite, but is " + radius + " m");
        }
    }

    @Override
    public double boundingRadius() {
        return radius;
    }

    @Override
    public Mat3 inertia(double mass) {
        double i = 0.4 * mass * radius * radius;
        return Mat3.diagonal(i, i, i);
    }

    @Override
    public boolean contains(Vec3 point) {
        return point.dot(point) <= radius * radius;
    }

    @Override
    public double distance(Ray ray) {
        return ray.ball(0, radius);
    }
}
