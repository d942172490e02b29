package org.auvsim.core.step;

/**
 * Coordinates of curves in Bezier form: control point i of a coordinate stands at {@code at + i *
 * stride}. With several parameters it is the blossom: the control points of the part from s to t of
 * a cubic are those for (s, s, s), (s, s, t), (s, t, t) and (t, t, t) (Ramshaw 1989).
 */
final class Bezier {
    private Bezier() {}

    /** The coordinate of a cubic at {@code s}. */
    static double cubic(double[] points, int at, int stride, double s) {
        double r = 1 - s;
        double p0 = points[at];
        double p1 = points[at + stride];
        double p2 = points[at + 2 * stride];
        double p3 = points[at + 3 * stride];
        return r * r * (r * p0 + 3 * s * p1) + s * s * (3 * r * p2 + s * p3);
    }

    /** The blossom of a cubic. */
    static double cubic(double[] points, int at, int stride, double s, double t, double u) {
        double p0 = points[at];
        double p1 = points[at + stride];
        double p2 = points[at + 2 * stride];
        double p3 = points[at + 3 * stride];
        double a = mix(mix(p0, p1, s), mix(p1, p2, s), t);
        double b = mix(mix(p1, p2, s), mix(p2, p3, s), t);
        return mix(a, b, u);
    }

    /** The blossom of a parabola. */
    static double quadratic(double[] points, int at, int stride, double s, double t) {
        double p0 = points[at];
        double p1 = points[at + stride];
        double p2 = points[at + 2 * stride];
        return mix(mix(p0, p1, s), mix(p1, p2, s), t);
    }

    private static double mix(double a, double b, double s) {
        return (1 - s) * a + s * b;
    }
}
