package org.auvsim.core.volume;

import org.auvsim.core.math.Quat;
import org.auvsim.core.math.Vec3;

/**
 * A straight line from a point on, as far as a range: a beam of sound or light.
 *
 * @param from where it begins (m)
 * @param direction of length 1
 * @param range how far it goes (m)
 */
public record Ray(Vec3 from, Vec3 direction, double range) {
    /** The answer of what a ray does not meet. */
    public static final double MISS = Double.POSITIVE_INFINITY;

    /** The point at a distance (m). */
    public Vec3 at(double distance) {
        return from.plus(direction.times(distance));
    }

    /** The same ray in the coordinates of a body at a position (m), turned by an orientation. */
    public Ray seenFrom(Vec3 position, Quat orientation) {
        return new Ray(
                orientation.rotateInverse(from.minus(position)),
                orientation.rotateInverse(direction),
                range);
    }

    /** A distance within the range, or a miss. */
    double within(double distance) {
        return distance <= range ? distance : MISS;
    }

    /** Where it enters a ball about a point (m); 0 from inside. */
    double ball(double x, double radius) {
        Vec3 to = new Vec3(from.x() - x, from.y(), from.z());
        if (to.dot(to) <= radius * radius) {
            return 0;
        }
        double along = -to.dot(direction);
        Vec3 beside = to.plus(direction.times(along));
        double half = radius * radius - beside.dot(beside);
        return along > 0 && half >= 0 ? within(along - Math.sqrt(half)) : MISS;
    }
}
