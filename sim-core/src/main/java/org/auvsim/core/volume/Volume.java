package org.auvsim.core.volume;

import org.auvsim.core.math.Mat3;
import org.auvsim.core.math.Vec3;

/**
 * A solid of constant density, in body coordinates.
 *
 * <p>A volume of a user's own implements this and registers a {@link PairQuery} with each kind of
 * volume that it is to meet.
 */
public interface Volume {
    /** In so many parts a ray's way is looked at, of a volume that has no better answer. */
    int PLACES = 1000;

    /**
     * Radius (m) of the smallest sphere about the origin that holds the volume; infinite if it goes
     * on for ever.
     */
    double boundingRadius();

    /**
     * Inertia tensor about the centre of mass, body axes (kg m^2), of this volume with {@code mass}
     * (kg).
     *
     * @throws IllegalArgumentException if the volume goes on for ever
     */
    Mat3 inertia(double mass);

    /** Whether a point (m, body coordinates) lies inside or on the surface. */
    boolean contains(Vec3 point);

    /** Centre of mass (m, body coordinates). */
    default Vec3 centreOfMass() {
        return Vec3.ZERO;
    }

    /** Whether a sphere holds it; what goes on for ever is only for fixed objects. */
    default boolean isBounded() {
        return boundingRadius() < Double.POSITIVE_INFINITY;
    }

    /**
     * Writes a box along the world's axes that holds the volume in a pose: least x, y, z, then
     * greatest x, y, z (m), from {@code to[at]} on. Allocates nothing.
     */
    default void bounds(Pose pose, double[] to, int at) {
        to[at] = pose.x - reach(pose, -1, 0, 0);
        to[at + 1] = pose.y - reach(pose, 0, -1, 0);
        to[at + 2] = pose.z - reach(pose, 0, 0, -1);
        to[at + 3] = pose.x + reach(pose, 1, 0, 0);
        to[at + 4] = pose.y + reach(pose, 0, 1, 0);
        to[at + 5] = pose.z + reach(pose, 0, 0, 1);
    }

    /**
     * How far (m) the volume in a pose reaches from the pose's origin along a unit vector (world),
     * or more. Allocates nothing.
     */
    default double reach(Pose pose, double nx, double ny, double nz) {
        return boundingRadius();
    }

    /**
     * How far along a ray (body coordinates) the volume begins (m): 0 from inside, {@link Ray#MISS}
     * if not within the ray's range.
     *
     * <p>Without an answer of its own, a volume is looked for in {@value #PLACES} places on the
     * ray's way through its bounding sphere, and what is thinner than the way from one to the next
     * can be missed.
     */
    default double distance(Ray ray) {
        double nearest = Math.max(0, -ray.from().dot(ray.direction()) - boundingRadius());
        double farthest = Math.min(ray.range(), boundingRadius() - ray.from().dot(ray.direction()));
        double before = nearest;
        for (int i = 0; i <= PLACES && nearest <= farthest; i++) {
            double at = nearest + (farthest - nearest) * i / PLACES;
            if (contains(ray.at(at))) {
                return entry(ray, before, at);
            }
            before = at;
        }
        return Ray.MISS;
    }

    private double entry(Ray ray, double outside, double inside) {
        double low = outside;
        double high = inside;
        for (double middle = (low + high) / 2;
                middle > low && middle < high;
                middle = (low + high) / 2) {
            if (contains(ray.at(middle))) {
                high = middle;
            } else {
                low = middle;
            }
        }
        return high;
    }
}
