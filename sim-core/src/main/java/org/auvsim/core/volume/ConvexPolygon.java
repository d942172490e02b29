package org.auvsim.core.volume;

import org.auvsim.core.math.Vec3;

import java.util.ArrayList;
import java.util.List;

/** A flat convex polygon in space; its corners in order round it. */
record ConvexPolygon(List<Vec3> corners) {
    /** Area below which, by the square of the longest diagonal, a polygon is a mere line. */
    private static final double SLIVER = 1e-6;

    /** The part with p . n &lt;= limit (Sutherland &amp; Hodgman 1974); perhaps without corners. */
    ConvexPolygon clipped(Vec3 n, double limit) {
        List<Vec3> kept = new ArrayList<>();
        for (int i = 0; i < corners.size(); i++) {
            Vec3 here = corners.get(i);
            Vec3 next = corners.get((i + 1) % corners.size());
            double inside = limit - here.dot(n);
            double nextInside = limit - next.dot(n);
            if (inside >= 0) {
                kept.add(here);
            }
            if ((inside > 0 && nextInside < 0) || (inside < 0 && nextInside > 0)) {
                double share = inside / (inside - nextInside);
                kept.add(here.plus(next.minus(here).times(share)));
            }
        }
        return new ConvexPolygon(kept);
    }

    boolean isEmpty() {
        return corners.isEmpty();
    }

    /** Centre of area; of a line or a point, the mean of the corners. */
    Vec3 centroid() {
        Vec3 origin = corners.getFirst();
        Vec3 weighted = Vec3.ZERO;
        double area = 0;
        double diagonal = 0;
        for (int i = 1; i < corners.size(); i++) {
            Vec3 u = corners.get(i).minus(origin);
            diagonal = Math.max(diagonal, u.dot(u));
            if (i + 1 < corners.size()) {
                Vec3 v = corners.get(i + 1).minus(origin);
                double part = u.cross(v).norm();
                weighted = weighted.plus(u.plus(v).times(part / 3));
                area += part;
            }
        }
        return area > SLIVER * diagonal ? origin.plus(weighted.times(1 / area)) : mean();
    }

    private Vec3 mean() {
        Vec3 sum = Vec3.ZERO;
        for (Vec3 corner : corners) {
            sum = sum.plus(corner);
        }
        return sum.times(1.0 / corners.size());
    }
}
