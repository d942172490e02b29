package org.auvsim.core.volume;

import org.auvsim.core.math.Quat;
import org.auvsim.core.math.Vec3;

/**
 * A ball and a box: the point of the box that is nearest to the ball's centre decides (Ericson,
 * Real-Time Collision Detection, 2005, section 5.1.4).
 */
final class SphereBox implements PairQuery<Sphere, Box> {
    private final SolidPair<Sphere, Box> solids = new SolidPair<>();

    @Override
    public boolean overlap(Sphere sphere, Pose poseA, Box box, Pose poseB) {
        double dx = poseA.x - poseB.x;
        double dy = poseA.y - poseB.y;
        double dz = poseA.z - poseB.z;
        double ox = outside(poseB.alongX(dx, dy, dz), box.size().x() / 2);
        double oy = outside(poseB.alongY(dx, dy, dz), box.size().y() / 2);
        double oz = outside(poseB.alongZ(dx, dy, dz), box.size().z() / 2);
        return ox * ox + oy * oy + oz * oz <= sphere.radius() * sphere.radius();
    }

    private static double outside(double coordinate, double half) {
        return Math.max(0, Math.abs(coordinate) - half);
    }

    @Override
    public ContactPoint contact(Sphere sphere, Pose poseA, Box box, Pose poseB) {
        Quat turn = poseB.orientation();
        Vec3 centre = turn.rotateInverse(poseA.position().minus(poseB.position()));
        Vec3 half = box.halfSize();
        Vec3 nearest =
                new Vec3(
                        Math.clamp(centre.x(), -half.x(), half.x()),
                        Math.clamp(centre.y(), -half.y(), half.y()),
                        Math.clamp(centre.z(), -half.z(), half.z()));
        Vec3 gap = centre.minus(nearest);
        double distance = gap.norm();
        if (distance > 0) {
            Vec3 normal = turn.rotate(gap.times(1 / distance));
            double depth = sphere.radius() - distance;
            return new ContactPoint(toWorld(nearest, turn, poseB), normal, depth);
        }
        return centreInside(sphere, centre, half, turn, poseB);
    }

    /** The ball's centre is inside the box: out through the nearest face. */
    private static ContactPoint centreInside(
            Sphere sphere, Vec3 centre, Vec3 half, Quat turn, Pose poseB) {
        double dx = half.x() - Math.abs(centre.x());
        double dy = half.y() - Math.abs(centre.y());
        double dz = half.z() - Math.abs(centre.z());
        Vec3 outward;
        if (dx <= dy && dx <= dz) {
            outward = new Vec3(Math.copySign(1, centre.x()), 0, 0);
        } else if (dy <= dz) {
            outward = new Vec3(0, Math.copySign(1, centre.y()), 0);
        } else {
            outward = new Vec3(0, 0, Math.copySign(1, centre.z()));
        }
        double toFace = Math.min(dx, Math.min(dy, dz));
        Vec3 onFace = centre.plus(outward.times(toFace));
        return new ContactPoint(
                toWorld(onFace, turn, poseB), turn.rotate(outward), sphere.radius() + toFace);
    }

    private static Vec3 toWorld(Vec3 local, Quat turn, Pose pose) {
        return turn.rotate(local).plus(pose.position());
    }

    @Override
    public double distance(Sphere sphere, Pose poseA, Box box, Pose poseB, Separation to) {
        return solids.distance(sphere, poseA, box, poseB, to);
    }

    @Override
    public void manifold(
            Sphere sphere, Pose poseA, Box box, Pose poseB, double margin, Manifold to) {
        solids.manifold(sphere, poseA, box, poseB, margin, to);
    }
}
