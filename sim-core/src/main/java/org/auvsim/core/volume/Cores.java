package org.auvsim.core.volume;

/** What finds distance and contact points of two convex solids, by the kinds of their cores. */
final class Cores {
    private Cores() {}

    /** A gap that the two solids cannot go below, by their bounding spheres (m). */
    static double leastGap(Core a, Core b) {
        double dx = a.x - b.x;
        double dy = a.y - b.y;
        double dz = a.z - b.z;
        return Math.sqrt(dx * dx + dy * dy + dz * dz) - a.reach - b.reach;
    }

    /** Completes {@code to} with the distance of two solids. */
    static void measure(Core a, Core b, Separation to) {
        if (a.dimensions < 2 && b.dimensions < 2) {
            Segments.measure(a, b, to);
        } else if (a.dimensions == 0) {
            PointBox.measure(a, b, to);
        } else if (b.dimensions == 0) {
            PointBox.measure(b, a, to);
            to.flip();
        } else {
            to.polytopes.measure(a, b, to);
        }
    }

    /** Adds the contact points of two solids if they are no farther apart than the margin. */
    static void touch(Core a, Core b, double margin, Manifold to) {
        Separation nearest = to.nearest;
        measure(a, b, nearest);
        if (nearest.distance > margin) {
            return;
        }
        if (a.dimensions == 0 || b.dimensions == 0) {
            to.add(nearest);
        } else if (a.dimensions == 1 && b.dimensions == 1) {
            ParallelSegments.touch(a, b, margin, to);
        } else {
            to.face.touch(a, b, margin, to);
        }
    }
}
