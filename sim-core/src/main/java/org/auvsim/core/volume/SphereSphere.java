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

    @Override
    public double distance(Sphere a, Pose poseA, Sphere b, Pose poseB, Separation to) {
        double dx = poseA.x - poseB.x;
        double dy = poseA.y - poseB.y;
        double dz = poseA.z - poseB.z;
        double centres = Math.sqrt(dx * dx + dy * dy + dz * dz);
        if (centres > 0) {
            to.normal(dx / centres, dy / centres, dz / centres);
        } else {
            to.normal(0, 0, 1);
        }
        double ra = a.radius();
        double rb = b.radius();
        to.px = ((poseA.x - to.nx * ra) + (poseB.x + to.nx * rb)) / 2;
        to.py = ((poseA.y - to.ny * ra) + (poseB.y + to.ny * rb)) / 2;
        to.pz = ((poseA.z - to.nz * ra) + (poseB.z + to.nz * rb)) / 2;
        to.distance = centres - (ra + rb);
        return to.distance;
    }
}
