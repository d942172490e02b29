package org.auvsim.core.volume;

import org.auvsim.core.math.Vec3;

/**
 * Answers for one pair of kinds of volume whether and where two of them touch.
 *
 * <p>Distance and manifold follow from {@link #contact} unless a query knows better. For that, the
 * depth of volumes far apart must be right too, or say that they are nearer than they are.
 */
public interface PairQuery<A extends Volume, B extends Volume> {
    /** Whether the two share a point; touching surfaces do. */
    boolean overlap(A a, Pose poseA, B b, Pose poseB);

    /** The contact of two volumes that overlap or nearly touch. */
    ContactPoint contact(A a, Pose poseA, B b, Pose poseB);

    /**
     * Measures the gap between the surfaces, which is never more than the true distance while the
     * volumes are apart, and 0 or less when they share a point.
     *
     * @param to takes gap, normal from {@code b} to {@code a} and place
     * @return the gap (m)
     */
    default double distance(A a, Pose poseA, B b, Pose poseB, Separation to) {
        ContactPoint contact = contact(a, poseA, b, poseB);
        Vec3 normal = contact.normal();
        Vec3 point = contact.point();
        to.distance = -contact.depth();
        to.nx = normal.x();
        to.ny = normal.y();
        to.nz = normal.z();
        to.px = point.x();
        to.py = point.y();
        to.pz = point.z();
        return to.distance;
    }

    /**
     * Finds the points where the surfaces are no farther apart than the margin.
     *
     * @param margin (m), 0 or more
     * @param to takes the points, in place of those that it has; none if the volumes are farther
     *     apart than the margin
     */
    default void manifold(A a, Pose poseA, B b, Pose poseB, double margin, Manifold to) {
        to.clear();
        if (distance(a, poseA, b, poseB, to.nearest) <= margin) {
            to.add(to.nearest);
        }
    }
}
