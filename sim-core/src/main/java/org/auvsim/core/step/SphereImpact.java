package org.auvsim.core.step;

/**
 * First touch of two spheres whose centres follow cubic paths, without a sampled instant.
 *
 * <p>Over s in [0, 1] the relative position d(s) = A - B is a cubic in Bezier form and the reach
 * r(s) (sum of the radii) is linear, so f(s) = |d|^2 - r^2 is a polynomial of degree 6. All its
 * Bernstein coefficients positive proves that there is no contact; exactly one change of sign
 * proves exactly one root (Descartes' rule), which bracketed Newton finds; with more changes the
 * path is halved, the left half first (Lane and Riesenfeld 1981, "Bounds on a polynomial").
 *
 * <p>Rounding: values of f within {@value #GRAZE} r^2 of zero count as zero, so a graze that is
 * shallower than 5e-13 of the reach is no contact, and neither is such an approach of two spheres
 * that touch. At the instant returned the overlap is below 1e-15 (|d| + r) of the path's largest
 * |d|.
 *
 * <p>Holds scratch: one for each thread. Allocates nothing after construction.
 */
final class SphereImpact {
    /** Values of f below this times the square of the reach count as zero. */
    private static final double GRAZE = 1e-12;

    /** Coefficients of f carry errors up to this times the largest |d|^2 + r^2. */
    private static final double ROUNDING = 0x1p-50;

    /** Halvings before a part of the path counts as an instant. */
    private static final int DEPTH = 45;

    private static final double INSTANT = 0x1p-45;

    private static final int POINTS = 12;
    private static final int NEWTON_STEPS = 80;

    private final double[] b = new double[7];
    private final double[] parts = new double[(DEPTH + 1) * POINTS];
    private final double[] starts = new double[DEPTH + 1];
    private final double[] widths = new double[DEPTH + 1];
    private double largestSquare;

    /**
     * First s in [0, 1] at which the spheres touch; infinity if they do not. Spheres that touch at
     * s = 0 already are answered as by {@link #next}.
     *
     * @param d from {@code at}: x, y, z of the four Bezier points of (centre of A - centre of B), m
     * @param reach0 sum of the radii at s = 0, m
     * @param reach1 sum of the radii at s = 1, m
     */
    double first(double[] d, int at, double reach0, double reach1) {
        if (apart(d, at, reach0, reach1)) return Double.POSITIVE_INFINITY;
        double reach = Math.max(reach0, reach1);
        return search(d, at, reach0, reach1, b[0] <= GRAZE * reach * reach);
    }

    /**
     * The same for spheres that touch at s = 0: 0 if they approach, else the first later touch. The
     * root at 0 is divided out, so it is not found again. Spheres that overlap at s = 0 count as
     * touching: what is found is the first instant after which they would overlap more.
     */
    double next(double[] d, int at, double reach0, double reach1) {
        apart(d, at, reach0, reach1);
        if (b[1] > b[0]
                && b[2] > b[0]
                && b[3] > b[0]
                && b[4] > b[0]
                && b[5] > b[0]
                && b[6] > b[0]) {
            return Double.POSITIVE_INFINITY;
        }
        return search(d, at, reach0, reach1, true);
    }

    /** Fills b with the Bernstein coefficients of f; true if all are positive. */
    private boolean apart(double[] d, int at, double reach0, double reach1) {
        double ax = d[at], ay = d[at + 1], az = d[at + 2];
        double bx = d[at + 3], by = d[at + 4], bz = d[at + 5];
        double cx = d[at + 6], cy = d[at + 7], cz = d[at + 8];
        double ex = d[at + 9], ey = d[at + 10], ez = d[at + 11];
        double aa = ax * ax + ay * ay + az * az;
        double bb = bx * bx + by * by + bz * bz;
        double cc = cx * cx + cy * cy + cz * cz;
        double ee = ex * ex + ey * ey + ez * ez;
        double ab = ax * bx + ay * by + az * bz;
        double ac = ax * cx + ay * cy + az * cz;
        double ae = ax * ex + ay * ey + az * ez;
        double bc = bx * cx + by * cy + bz * cz;
        double be = bx * ex + by * ey + bz * ez;
        double ce = cx * ex + cy * ey + cz * ez;
        // The square of the reach (coefficients p, q, r in degree 2), raised to degree 6.
        double p = reach0 * reach0, q = reach0 * reach1, r = reach1 * reach1;
        double b0 = aa - p;
        double b1 = ab - (2 * p + q) * (1.0 / 3);
        double b2 = (2 * ac + 3 * bb) * 0.2 - (6 * p + 8 * q + r) * (1.0 / 15);
        double b3 = (ae + 9 * bc) * 0.1 - (p + 3 * q + r) * 0.2;
        double b4 = (2 * be + 3 * cc) * 0.2 - (p + 8 * q + 6 * r) * (1.0 / 15);
        double b5 = ce - (q + 2 * r) * (1.0 / 3);
        double b6 = ee - r;
        b[0] = b0;
        b[1] = b1;
        b[2] = b2;
        b[3] = b3;
        b[4] = b4;
        b[5] = b5;
        b[6] = b6;
        largestSquare = Math.max(Math.max(aa, bb), Math.max(cc, ee));
        return b0 > 0 && b1 > 0 && b2 > 0 && b3 > 0 && b4 > 0 && b5 > 0 && b6 > 0;
    }

    /** The first root, b already filled for the whole path. */
    private double search(double[] d, int at, double reach0, double reach1, boolean touching) {
        System.arraycopy(d, at, parts, 0, POINTS);
        starts[0] = 0;
        widths[0] = 1;
        int top = 0;
        boolean filled = true;
        while (top >= 0) {
            double start = starts[top], width = widths[top];
            double from = reach0 + (reach1 - reach0) * start;
            double to = reach0 + (reach1 - reach0) * (start + width);
            if (!filled) apart(parts, top * POINTS, from, to);
            filled = false;
            boolean divided = touching && start == 0;
            int roots = roots(divided, Math.max(from, to), width <= INSTANT);
            if (roots == AT_START) return start;
            if (roots == ONE) {
                double s = divided ? refineNext(top, from, to) : refineFirst(top, from, to);
                return start + width * s;
            }
            if (roots == NONE) top--;
            else if (width <= INSTANT) return start; // never late: at most this instant too early
            else halve(top++);
        }
        return Double.POSITIVE_INFINITY;
    }

    private static final int NONE = 0;
    private static final int ONE = 1;
    private static final int SEVERAL = 2;
    private static final int AT_START = -1;

    /** How many roots b has at most; {@code divided} divides the root at s = 0 out of it first. */
    private int roots(boolean divided, double reach, boolean instant) {
        int degree = divided ? divide() : 6;
        double graze = GRAZE * reach * reach;
        double rounding = ROUNDING * (largestSquare + reach * reach);
        double band = Math.max(graze, rounding);
        boolean doubtful = rounding > graze && !instant;
        int changes = 0;
        double sign = 0;
        for (int i = 0; i <= degree; i++) {
            if (Math.abs(b[i]) <= band) {
                if (doubtful) return SEVERAL; // the halves, closer to each other, decide
            } else if (sign == 0) {
                if (b[i] < 0) return AT_START;
                sign = b[i];
            } else if (sign * b[i] < 0) {
                sign = b[i];
                changes++;
            }
        }
        return Math.min(changes, SEVERAL);
    }

    /** Makes b the coefficients of (f(s) - f(0)) / s, of degree 5. */
    private int divide() {
        double b0 = b[0];
        for (int i = 0; i < 6; i++) b[i] = (b[i + 1] - b0) * (6.0 / (i + 1));
        return 5;
    }

    /** Replaces a part of the path by its right half and puts the left half on top of it. */
    private void halve(int top) {
        double width = 0.5 * widths[top];
        widths[top] = width;
        widths[top + 1] = width;
        starts[top + 1] = starts[top];
        starts[top] += width;
        for (int axis = 0; axis < 3; axis++) {
            int right = top * POINTS + axis, left = right + POINTS;
            double p0 = parts[right], p1 = parts[right + 3];
            double p2 = parts[right + 6], p3 = parts[right + 9];
            double p01 = 0.5 * (p0 + p1), p12 = 0.5 * (p1 + p2), p23 = 0.5 * (p2 + p3);
            double p012 = 0.5 * (p01 + p12), p123 = 0.5 * (p12 + p23);
            double middle = 0.5 * (p012 + p123);
            parts[left] = p0;
            parts[left + 3] = p01;
            parts[left + 6] = p012;
            parts[left + 9] = middle;
            parts[right] = middle;
            parts[right + 3] = p123;
            parts[right + 6] = p23;
        }
    }

    /** Where the polygon of the coefficients first falls below zero: near the one root. */
    private double guess(int degree) {
        for (int i = 0; i < degree; i++) {
            double above = b[i], below = b[i + 1];
            if (above > 0 && below <= 0) return (i + above / (above - below)) / degree;
        }
        return 0.5;
    }

    /** The one root of f in a part of the path; d and its derivative in power form (Horner). */
    private double refineFirst(int top, double reach0, double reach1) {
        int at = top * POINTS;
        double x0 = parts[at], y0 = parts[at + 1], z0 = parts[at + 2];
        double x1 = 3 * (parts[at + 3] - x0), x2 = 3 * (parts[at + 6] - parts[at + 3]) - x1;
        double y1 = 3 * (parts[at + 4] - y0), y2 = 3 * (parts[at + 7] - parts[at + 4]) - y1;
        double z1 = 3 * (parts[at + 5] - z0), z2 = 3 * (parts[at + 8] - parts[at + 5]) - z1;
        double x3 = parts[at + 9] - x0 - x1 - x2;
        double y3 = parts[at + 10] - y0 - y1 - y2;
        double z3 = parts[at + 11] - z0 - z1 - z2;
        double growth = reach1 - reach0, reach = Math.max(reach0, reach1);
        double enough = 0x1p-51 * reach * (Math.sqrt(largestSquare) + reach);
        double low = 0, high = 1, s = guess(6);
        for (int i = 0; i < NEWTON_STEPS; i++) {
            double x = x0 + s * (x1 + s * (x2 + s * x3)), dx = x1 + s * (2 * x2 + s * 3 * x3);
            double y = y0 + s * (y1 + s * (y2 + s * y3)), dy = y1 + s * (2 * y2 + s * 3 * y3);
            double z = z0 + s * (z1 + s * (z2 + s * z3)), dz = z1 + s * (2 * z2 + s * 3 * z3);
            double r = reach0 + s * growth;
            double f = x * x + y * y + z * z - r * r;
            if (Math.abs(f) <= enough) return s;
            if (f > 0) low = s;
            else high = s;
            s -= 0.5 * f / (x * dx + y * dy + z * dz - r * growth);
            if (!(s > low && s < high)) s = 0.5 * (low + high);
            if (s == low || s == high) return low;
        }
        return low;
    }

    /**
     * The one root of (f(s) - f(0)) / s; with d = d0 + s e that is 2 d0.e + s e.e - r'(2 r0 + s
     * r').
     */
    private double refineNext(int top, double reach0, double reach1) {
        int at = top * POINTS;
        double x0 = parts[at], y0 = parts[at + 1], z0 = parts[at + 2];
        double x1 = 3 * (parts[at + 3] - x0), x2 = 3 * (parts[at + 6] - parts[at + 3]) - x1;
        double y1 = 3 * (parts[at + 4] - y0), y2 = 3 * (parts[at + 7] - parts[at + 4]) - y1;
        double z1 = 3 * (parts[at + 5] - z0), z2 = 3 * (parts[at + 8] - parts[at + 5]) - z1;
        double x3 = parts[at + 9] - x0 - x1 - x2;
        double y3 = parts[at + 10] - y0 - y1 - y2;
        double z3 = parts[at + 11] - z0 - z1 - z2;
        double growth = reach1 - reach0;
        double enough = 0;
        for (int i = 0; i < 6; i++) enough = Math.max(enough, Math.abs(b[i]));
        enough *= 0x1p-51;
        double low = 0, high = 1, s = guess(5);
        for (int i = 0; i < NEWTON_STEPS; i++) {
            double x = x1 + s * (x2 + s * x3), dx = x2 + s * 2 * x3;
            double y = y1 + s * (y2 + s * y3), dy = y2 + s * 2 * y3;
            double z = z1 + s * (z2 + s * z3), dz = z2 + s * 2 * z3;
            double ee = x * x + y * y + z * z - growth * growth;
            double h = 2 * (x0 * x + y0 * y + z0 * z - growth * reach0) + s * ee;
            if (Math.abs(h) <= enough) return s;
            if (h > 0) low = s;
            else high = s;
            double along = (x0 + s * x) * dx + (y0 + s * y) * dy + (z0 + s * z) * dz;
            s -= h / (2 * along + ee);
            if (!(s > low && s < high)) s = 0.5 * (low + high);
            if (s == low || s == high) return low;
        }
        return low;
    }
}
