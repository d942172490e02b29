package org.auvsim.core.volume;

import org.auvsim.core.math.Vec3;

/** Two balls: they touch when their centres are no farther apart than the sum of their radii. */
final class SphereSphere implements PairQuery<Sphere, Sphere> {
    @Override
    public boolean overlap(Sphere a, Pose poseA, Sphere b, Pose poseB) {
        double dx = poseA.x - poseB.x;
        double dy = poseA.y - poseB.y;
        double dz = poseA.z - poseB.z;
        double reach = a.radius() + b.radius();
        return dx * dx + dy * dy + dz * dz <= reach * reach;
    }

    @Override
    public ContactPoint contact(Sphere a, Pose poseA, Sphere b, Pose poseB) {
        Vec3 fromB = poseA.position().minus(poseB.position());
        double distance = fromB.norm();
        // Concentric balls have no direction to part in; upward is as good as any, and the same
        // on every machine.
        Vec3 normal = distance > 0 ? fromB.times(1 / distance) : new Vec3(0, 0, 1);
        double depth = a.radius() + b.radius() - distance;
        Vec3 point = poseB.position().plus(normal.times(b.radius() - depth / 2));
        return new ContactPoint(point, normal, depth);
    }
}
