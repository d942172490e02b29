package org.auvsim.core.volume;

/**
 * Distance of a core that is a point and one that is a box (Ericson, Real-Time Collision Detection,
 * 2005, section 5.1.4).
 */
final class PointBox {
    private PointBox() {}

    /** Completes {@code to} for the two solids, of which the first has the point. */
    static void measure(Core point, Core box, Separation to) {
        double dx = point.x - box.x;
        double dy = point.y - box.y;
        double dz = point.z - box.z;
        double ox = outside(box, 0, dx, dy, dz);
        double oy = outside(box, 1, dx, dy, dz);
        double oz = outside(box, 2, dx, dy, dz);
        double distance = Math.sqrt(ox * ox + oy * oy + oz * oz);
        if (distance > 0) {
            normal(box, ox / distance, oy / distance, oz / distance, to);
        } else {
            distance = inside(box, dx, dy, dz, to);
        }
        to.swell(distance, point.radius, box.radius, point.x, point.y, point.z);
    }

    /** How far, with its sign, the point is beyond the faces of axis {@code i}. */
    private static double outside(Core box, int i, double dx, double dy, double dz) {
        double along = box.component(i, dx, dy, dz);
        return along > box.half[i]
                ? along - box.half[i]
                : along < -box.half[i] ? along + box.half[i] : 0;
    }

    /** Out through the nearest face. */
    private static double inside(Core box, double dx, double dy, double dz, Separation to) {
        double deepest = Double.NEGATIVE_INFINITY;
        for (int i = 0; i < 3; i++) {
            double along = box.component(i, dx, dy, dz);
            double distance = Math.abs(along) - box.half[i];
            if (distance > deepest) {
                deepest = distance;
                double out = along < 0 ? -1 : 1;
                normal(box, i == 0 ? out : 0, i == 1 ? out : 0, i == 2 ? out : 0, to);
            }
        }
        return deepest;
    }

    private static void normal(Core box, double x, double y, double z, Separation to) {
        double[] e = box.axes;
        to.normal(
                x * e[0] + y * e[3] + z * e[6],
                x * e[1] + y * e[4] + z * e[7],
                x * e[2] + y * e[5] + z * e[8]);
    }
}
