package org.auvsim.core.volume;

import org.auvsim.core.math.Vec3;

/** A query that measures distance and manifold, from which the rest follows. */
interface SolidQuery<A extends Volume, B extends Volume> extends PairQuery<A, B> {
    /** Points this much less deep than the deepest still belong to the contact (m). */
    double SLACK = 1e-6;

    @Override
    double distance(A a, Pose poseA, B b, Pose poseB, Separation to);

    @Override
    void manifold(A a, Pose poseA, B b, Pose poseB, double margin, Manifold to);

    @Override
    default boolean overlap(A a, Pose poseA, B b, Pose poseB) {
        return distance(a, poseA, b, poseB, new Separation()) <= 0;
    }

    /** The mean of the deepest points. */
    @Override
    default ContactPoint contact(A a, Pose poseA, B b, Pose poseB) {
        Manifold manifold = new Manifold();
        double distance = distance(a, poseA, b, poseB, manifold.nearest);
        Separation nearest = manifold.nearest;
        Vec3 point = new Vec3(nearest.px, nearest.py, nearest.pz);
        Vec3 normal = new Vec3(nearest.nx, nearest.ny, nearest.nz);
        manifold(a, poseA, b, poseB, Math.max(0, distance) + SLACK, manifold);
        int deepest = manifold.deepest();
        if (deepest < 0) {
            return new ContactPoint(point, normal, -distance);
        }
        Vec3 sum = Vec3.ZERO;
        int points = 0;
        for (int i = 0; i < manifold.count; i++) {
            if (manifold.gap[i] <= manifold.gap[deepest] + SLACK) {
                sum = sum.plus(new Vec3(manifold.x[i], manifold.y[i], manifold.z[i]));
                points++;
            }
        }
        return new ContactPoint(
                sum.times(1.0 / points),
                new Vec3(manifold.nx[deepest], manifold.ny[deepest], manifold.nz[deepest]),
                -distance);
    }
}
