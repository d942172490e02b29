package org.auvsim.core.volume;

/** Distance and manifold of two bounded volumes of this package, part by part. */
final class Solids {
    private Solids() {}

    /** An order of two volumes, by place, then orientation, then size. */
    static boolean inOrder(Volume a, Pose p, Volume b, Pose q) {
        if (p.x != q.x) {
            return p.x < q.x;
        }
        if (p.y != q.y) {
            return p.y < q.y;
        }
        if (p.z != q.z) {
            return p.z < q.z;
        }
        if (p.qw != q.qw) {
            return p.qw < q.qw;
        }
        if (p.qx != q.qx) {
            return p.qx < q.qx;
        }
        if (p.qy != q.qy) {
            return p.qy < q.qy;
        }
        return p.qz != q.qz ? p.qz < q.qz : a.boundingRadius() <= b.boundingRadius();
    }

    /** Completes {@code to} with the least distance of any two parts. */
    static void distance(Volume a, Pose poseA, Volume b, Pose poseB, Separation to) {
        int partsA = Core.parts(a);
        int partsB = Core.parts(b);
        if (partsA == 1 && partsB == 1) {
            to.first.place(a, 0, poseA);
            to.second.place(b, 0, poseB);
            Cores.measure(to.first, to.second, to);
            return;
        }
        to.keepFarthest();
        for (int i = 0; i < partsA; i++) {
            to.first.place(a, i, poseA);
            for (int j = 0; j < partsB; j++) {
                to.second.place(b, j, poseB);
                if (Cores.leastGap(to.first, to.second) < to.keptDistance()) {
                    Cores.measure(to.first, to.second, to);
                    to.keepIfLess();
                }
            }
        }
        to.restoreKept();
    }

    /** Adds the contact points of all pairs of parts that are no farther apart than the margin. */
    static void manifold(Volume a, Pose poseA, Volume b, Pose poseB, double margin, Manifold to) {
        Core first = to.nearest.first;
        Core second = to.nearest.second;
        for (int i = 0; i < Core.parts(a); i++) {
            first.place(a, i, poseA);
            for (int j = 0; j < Core.parts(b); j++) {
                second.place(b, j, poseB);
                if (Cores.leastGap(first, second) <= margin) {
                    Cores.touch(first, second, margin, to);
                }
            }
        }
    }
}
