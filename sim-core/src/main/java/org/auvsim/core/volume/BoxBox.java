package org.auvsim.core.volume;

import org.auvsim.core.math.Vec3;

/**
 * Two boxes: they are apart exactly if one of fifteen directions separates them (Gottschalk, Lin
 * &amp; Manocha 1996; Ericson, Real-Time Collision Detection, 2005, section 4.4.1).
 */
final class BoxBox implements PairQuery<Box, Box> {
    private final SolidPair<Box, Box> solids = new SolidPair<>();

    /**
     * Added to the cosines between edges: the cross product of parallel edges is rounding alone,
     * which must not separate boxes that touch.
     */
    private static final double PARALLEL = 1e-12;

    @Override
    public boolean overlap(Box a, Pose poseA, Box b, Pose poseB) {
        // All in the frame of a: where b's centre is, the cosines between the edges (row: edge of
        // a, column: edge of b), and their absolute values.
        double dx = poseB.x - poseA.x;
        double dy = poseB.y - poseA.y;
        double dz = poseB.z - poseA.z;
        double tx = poseA.alongX(dx, dy, dz);
        double ty = poseA.alongY(dx, dy, dz);
        double tz = poseA.alongZ(dx, dy, dz);
        double w =
                poseA.qw * poseB.qw
                        + poseA.qx * poseB.qx
                        + poseA.qy * poseB.qy
                        + poseA.qz * poseB.qz;
        double x =
                poseA.qw * poseB.qx
                        - poseA.qx * poseB.qw
                        - poseA.qy * poseB.qz
                        + poseA.qz * poseB.qy;
        double y =
                poseA.qw * poseB.qy
                        + poseA.qx * poseB.qz
                        - poseA.qy * poseB.qw
                        - poseA.qz * poseB.qx;
        double z =
                poseA.qw * poseB.qz
                        - poseA.qx * poseB.qy
                        + poseA.qy * poseB.qx
                        - poseA.qz * poseB.qw;
        double xx = 1 - 2 * (y * y + z * z);
        double xy = 2 * (x * y - w * z);
        double xz = 2 * (x * z + w * y);
        double yx = 2 * (x * y + w * z);
        double yy = 1 - 2 * (x * x + z * z);
        double yz = 2 * (y * z - w * x);
        double zx = 2 * (x * z - w * y);
        double zy = 2 * (y * z + w * x);
        double zz = 1 - 2 * (x * x + y * y);
        double axx = Math.abs(xx) + PARALLEL;
        double axy = Math.abs(xy) + PARALLEL;
        double axz = Math.abs(xz) + PARALLEL;
        double ayx = Math.abs(yx) + PARALLEL;
        double ayy = Math.abs(yy) + PARALLEL;
        double ayz = Math.abs(yz) + PARALLEL;
        double azx = Math.abs(zx) + PARALLEL;
        double azy = Math.abs(zy) + PARALLEL;
        double azz = Math.abs(zz) + PARALLEL;
        double ax = a.size().x() / 2;
        double ay = a.size().y() / 2;
        double az = a.size().z() / 2;
        double bx = b.size().x() / 2;
        double by = b.size().y() / 2;
        double bz = b.size().z() / 2;
        return Math.abs(tx) <= ax + bx * axx + by * axy + bz * axz
                && Math.abs(ty) <= ay + bx * ayx + by * ayy + bz * ayz
                && Math.abs(tz) <= az + bx * azx + by * azy + bz * azz
                && Math.abs(tx * xx + ty * yx + tz * zx) <= bx + ax * axx + ay * ayx + az * azx
                && Math.abs(tx * xy + ty * yy + tz * zy) <= by + ax * axy + ay * ayy + az * azy
                && Math.abs(tx * xz + ty * yz + tz * zz) <= bz + ax * axz + ay * ayz + az * azz
                && Math.abs(tz * yx - ty * zx) <= ay * azx + az * ayx + by * axz + bz * axy
                && Math.abs(tz * yy - ty * zy) <= ay * azy + az * ayy + bx * axz + bz * axx
                && Math.abs(tz * yz - ty * zz) <= ay * azz + az * ayz + bx * axy + by * axx
                && Math.abs(tx * zx - tz * xx) <= ax * azx + az * axx + by * ayz + bz * ayy
                && Math.abs(tx * zy - tz * xy) <= ax * azy + az * axy + bx * ayz + bz * ayx
                && Math.abs(tx * zz - tz * xz) <= ax * azz + az * axz + bx * ayy + by * ayx
                && Math.abs(ty * xx - tx * yx) <= ax * ayx + ay * axx + by * azz + bz * azy
                && Math.abs(ty * xy - tx * yy) <= ax * ayy + ay * axy + bx * azz + bz * azx
                && Math.abs(ty * xz - tx * yz) <= ax * ayz + ay * axz + bx * azy + by * azx;
    }

    /**
     * The direction of least overlap and the middle of the surfaces that meet; of boxes that are
     * apart, the direction that separates them most. The boxes are taken in one order whichever way
     * they are given, so that both ways give the same contact to the bit.
     */
    @Override
    public ContactPoint contact(Box a, Pose poseA, Box b, Pose poseB) {
        OrientedBox first = OrientedBox.of(a, poseA);
        OrientedBox second = OrientedBox.of(b, poseB);
        return OrientedBox.ORDER.compare(first, second) <= 0
                ? contact(first, second)
                : contact(second, first).flipped();
    }

    private static ContactPoint contact(OrientedBox a, OrientedBox b) {
        LeastPenetration least = LeastPenetration.of(a, b);
        return new ContactPoint(middle(least, a, b), least.normal(), least.depth());
    }

    private static Vec3 middle(LeastPenetration least, OrientedBox a, OrientedBox b) {
        Vec3 towardB = least.normal().negated();
        if (least.isOfEdges()) {
            return CrossingEdges.middle(a, least.ofA(), towardB, b, least.ofB());
        }
        return least.ofB() == LeastPenetration.NONE
                ? FaceManifold.middle(a, least.ofA(), towardB, b)
                : FaceManifold.middle(b, least.ofB(), least.normal(), a);
    }

    @Override
    public double distance(Box a, Pose poseA, Box b, Pose poseB, Separation to) {
        return solids.distance(a, poseA, b, poseB, to);
    }

    @Override
    public void manifold(Box a, Pose poseA, Box b, Pose poseB, double margin, Manifold to) {
        solids.manifold(a, poseA, b, poseB, margin, to);
    }
}
