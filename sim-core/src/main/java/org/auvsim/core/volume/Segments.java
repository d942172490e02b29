package org.auvsim.core.volume;

/**
 * Distance of two cores that are points or segments (Ericson, Real-Time Collision Detection, 2005,
 * section 5.1.9). The least is either where the common perpendicular meets both, or at an end of
 * one of them; all ends are tried, since near parallel segments leave the perpendicular's foot
 * uncertain.
 */
final class Segments {
    /** Squared sine below which segments count as parallel: the perpendicular is rounding alone. */
    private static final double PARALLEL = 1e-24;

    private Segments() {}

    /** Completes {@code to} for the two solids. */
    static void measure(Core a, Core b, Separation to) {
        double[] u = a.axes;
        double[] v = b.axes;
        double dx = a.x - b.x;
        double dy = a.y - b.y;
        double dz = a.z - b.z;
        double p = a.half[0];
        double q = b.half[0];
        double cx = u[1] * v[2] - u[2] * v[1];
        double cy = u[2] * v[0] - u[0] * v[2];
        double cz = u[0] * v[1] - u[1] * v[0];
        double cc = cx * cx + cy * cy + cz * cz;
        if (p > 0 && q > 0 && cc > PARALLEL) {
            double s = -triple(dx, dy, dz, v, cx, cy, cz) / cc;
            double t = -triple(dx, dy, dz, u, cx, cy, cz) / cc;
            if (Math.abs(s) <= p && Math.abs(t) <= q) {
                double along = (dx * cx + dy * cy + dz * cz) / Math.sqrt(cc);
                double k = (along < 0 ? -1 : 1) / Math.sqrt(cc);
                to.normal(k * cx, k * cy, k * cz);
                swell(a, b, Math.abs(along), s, to);
                return;
            }
        }
        ends(a, b, dx, dy, dz, to);
    }

    /** (d x e) . c */
    private static double triple(
            double dx, double dy, double dz, double[] e, double cx, double cy, double cz) {
        return (dy * e[2] - dz * e[1]) * cx
                + (dz * e[0] - dx * e[2]) * cy
                + (dx * e[1] - dy * e[0]) * cz;
    }

    private static void ends(Core a, Core b, double dx, double dy, double dz, Separation to) {
        double p = a.half[0];
        double q = b.half[0];
        double bestS = 0;
        double bestT = 0;
        double best = Double.POSITIVE_INFINITY;
        for (int end = 0; end < 4; end++) {
            double sign = (end & 1) == 0 ? 1 : -1;
            double s;
            double t;
            if (end < 2) {
                s = sign * p;
                t = clamp(b.component(0, dx, dy, dz) + s * cosine(a, b), q);
            } else {
                t = sign * q;
                s = clamp(t * cosine(a, b) - a.component(0, dx, dy, dz), p);
            }
            double squared = squared(a, b, dx, dy, dz, s, t);
            if (squared < best) {
                best = squared;
                bestS = s;
                bestT = t;
            }
        }
        finish(a, b, dx, dy, dz, bestS, bestT, to);
    }

    private static void finish(
            Core a, Core b, double dx, double dy, double dz, double s, double t, Separation to) {
        double x = dx + s * a.axes[0] - t * b.axes[0];
        double y = dy + s * a.axes[1] - t * b.axes[1];
        double z = dz + s * a.axes[2] - t * b.axes[2];
        double length = Math.sqrt(x * x + y * y + z * z);
        if (length > 0) {
            to.normal(x / length, y / length, z / length);
        } else {
            across(a.half[0] > 0 ? a : b, to);
        }
        swell(a, b, length, s, to);
    }

    private static double clamp(double value, double limit) {
        return Math.max(-limit, Math.min(limit, value));
    }

    private static double cosine(Core a, Core b) {
        return a.component(0, b.axes[0], b.axes[1], b.axes[2]);
    }

    private static double squared(
            Core a, Core b, double dx, double dy, double dz, double s, double t) {
        double x = dx + s * a.axes[0] - t * b.axes[0];
        double y = dy + s * a.axes[1] - t * b.axes[1];
        double z = dz + s * a.axes[2] - t * b.axes[2];
        return x * x + y * y + z * z;
    }

    /**
     * Cores that touch leave no direction to part in: upward, for a segment as far as that is
     * across it, is as good as any, and the same on every machine.
     */
    private static void across(Core segment, Separation to) {
        if (segment.dimensions == 0) {
            to.normal(0, 0, 1);
            return;
        }
        double x = segment.axes[0];
        double y = segment.axes[1];
        double z = segment.axes[2];
        double length = Math.sqrt(x * x + y * y);
        if (length > 1e-6) {
            to.normal(-z * x / length, -z * y / length, length);
        } else {
            to.normal(1, 0, 0);
        }
    }

    private static void swell(Core a, Core b, double cores, double s, Separation to) {
        to.swell(
                cores,
                a.radius,
                b.radius,
                a.x + s * a.axes[0],
                a.y + s * a.axes[1],
                a.z + s * a.axes[2]);
    }
}
