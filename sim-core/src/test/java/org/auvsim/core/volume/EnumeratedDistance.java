package org.auvsim.core.volume;

import org.auvsim.core.math.Vec3;

import java.util.ArrayList;
import java.util.List;

/**
 * The distance of two convex volumes by trying everything: all corners of one against the other,
 * all edges of one against those of the other. Slow and simple, to test the quick ones.
 */
final class EnumeratedDistance {
    private EnumeratedDistance() {}

    /** A point, segment or box, and a radius about it. */
    private record Body(Vec3 centre, List<Vec3> halves, double radius) {
        static Body of(Volume volume, Pose pose) {
            List<Vec3> halves = new ArrayList<>();
            double radius = 0;
            switch (volume) {
                case Sphere sphere -> radius = sphere.radius();
                case Capsule capsule -> {
                    halves.add(turned(pose, new Vec3(capsule.length() / 2, 0, 0)));
                    radius = capsule.radius();
                }
                case Box box -> {
                    Vec3 h = box.halfSize();
                    halves.add(turned(pose, new Vec3(h.x(), 0, 0)));
                    halves.add(turned(pose, new Vec3(0, h.y(), 0)));
                    halves.add(turned(pose, new Vec3(0, 0, h.z())));
                }
                default -> throw new IllegalArgumentException(volume.toString());
            }
            return new Body(pose.position(), halves, radius);
        }

        private static Vec3 turned(Pose pose, Vec3 v) {
            return pose.orientation().rotate(v);
        }

        List<Vec3> corners() {
            List<Vec3> corners = List.of(centre);
            for (Vec3 half : halves) {
                List<Vec3> more = new ArrayList<>();
                for (Vec3 corner : corners) {
                    more.add(corner.plus(half));
                    more.add(corner.minus(half));
                }
                corners = more;
            }
            return corners;
        }

        /** Each edge as its two ends. */
        List<Vec3[]> edges() {
            List<Vec3[]> edges = new ArrayList<>();
            for (int i = 0; i < halves.size(); i++) {
                Vec3 half = halves.get(i);
                List<Vec3> others = new ArrayList<>(halves);
                others.remove(i);
                for (Vec3 middle : new Body(centre, others, 0).corners()) {
                    edges.add(new Vec3[] {middle.minus(half), middle.plus(half)});
                }
            }
            return edges;
        }

        /** From a point to the core. */
        double distance(Vec3 point) {
            Vec3 rest = point.minus(centre);
            for (Vec3 half : halves) {
                double share = rest.dot(half) / half.dot(half);
                rest = rest.minus(half.times(Math.clamp(share, -1, 1)));
            }
            return rest.norm();
        }
    }

    /** The gap of the two; minus the radii if their cores touch. */
    static double between(Volume a, Pose poseA, Volume b, Pose poseB) {
        Body first = Body.of(a, poseA);
        Body second = Body.of(b, poseB);
        double least = Double.POSITIVE_INFINITY;
        for (Vec3 corner : first.corners()) {
            least = Math.min(least, second.distance(corner));
        }
        for (Vec3 corner : second.corners()) {
            least = Math.min(least, first.distance(corner));
        }
        for (Vec3[] e : first.edges()) {
            for (Vec3[] f : second.edges()) {
                least = Math.min(least, across(e[0], e[1], f[0], f[1]));
            }
            if (second.halves.size() == 3 && passesThrough(e, second)) {
                least = 0;
            }
        }
        for (Vec3[] f : second.edges()) {
            if (first.halves.size() == 3 && passesThrough(f, first)) {
                least = 0;
            }
        }
        return least - first.radius - second.radius;
    }

    /** Between points of two segments, near where the common perpendicular of the lines meets. */
    private static double across(Vec3 a, Vec3 b, Vec3 c, Vec3 d) {
        Vec3 u = b.minus(a);
        Vec3 v = d.minus(c);
        Vec3 n = u.cross(v);
        Vec3 w = c.minus(a);
        double nn = n.dot(n);
        if (nn == 0) {
            return Double.POSITIVE_INFINITY;
        }
        double s = Math.clamp(w.cross(v).dot(n) / nn, 0, 1);
        double t = Math.clamp(w.cross(u).dot(n) / nn, 0, 1);
        return a.plus(u.times(s)).distance(c.plus(v.times(t)));
    }

    /** Whether a segment has a point in a box: slab by slab. */
    private static boolean passesThrough(Vec3[] segment, Body box) {
        Vec3 way = segment[1].minus(segment[0]);
        Vec3 start = segment[0].minus(box.centre);
        double from = 0;
        double till = 1;
        for (Vec3 half : box.halves) {
            double length = half.dot(half);
            double at = start.dot(half) / length;
            double speed = way.dot(half) / length;
            if (speed == 0) {
                if (Math.abs(at) > 1) {
                    return false;
                }
                continue;
            }
            double one = (-1 - at) / speed;
            double other = (1 - at) / speed;
            from = Math.max(from, Math.min(one, other));
            till = Math.min(till, Math.max(one, other));
        }
        return from <= till;
    }
}
