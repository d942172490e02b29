package org.auvsim.core.volume;

/**
 * Contact points of a box and a box or segment: the part of one's face, or of the segment, that
 * lies above the other's face. Room to calculate in belongs to it: one a thread.
 */
final class FaceClip {
    /**
     * A face must be worse than an earlier one by these shares of gap and size to be passed over.
     */
    private static final double SHARE_OF_GAP = 0.02;

    private static final double SHARE_OF_SIZE = 1e-6;

    /** Corners nearer to each other than this share of the size are one. */
    private static final double SAME = 1e-12;

    /** Corners across the face: along its two edges, then height above it; 12 of them fit. */
    private double[] corners = new double[36];

    private double[] spare = new double[36];
    private int count;

    private double faceGap;
    private int face;
    private boolean ofFirst;

    /** Adds the points, given the two solids' separation in the manifold. */
    void touch(Core a, Core b, double margin, Manifold to) {
        double size = a.reach + b.reach;
        double cores = to.nearest.distance + a.radius + b.radius;
        choose(a, b, size);
        if (cores > faceGap + allowance(faceGap, size)) {
            to.add(to.nearest);
            return;
        }
        Core base = ofFirst ? a : b;
        Core other = ofFirst ? b : a;
        double least = clip(base, other, margin, size, to);
        if (to.nearest.distance < least - SHARE_OF_SIZE * size) {
            to.add(to.nearest);
        }
    }

    private static double allowance(double gap, double size) {
        return SHARE_OF_GAP * Math.abs(gap) + SHARE_OF_SIZE * size;
    }

    /** The face that separates the two most; an earlier one unless a later is clearly better. */
    private void choose(Core a, Core b, double size) {
        faceGap = Double.NEGATIVE_INFINITY;
        for (int i = 0; a.dimensions == 3 && i < 3; i++) {
            offer(a, b, i, true, size);
        }
        for (int i = 0; b.dimensions == 3 && i < 3; i++) {
            offer(b, a, i, false, size);
        }
    }

    private void offer(Core base, Core other, int i, boolean first, double size) {
        double[] e = base.axes;
        double centre = base.component(i, other.x - base.x, other.y - base.y, other.z - base.z);
        double gap =
                Math.abs(centre) - base.half[i] - other.along(e[3 * i], e[3 * i + 1], e[3 * i + 2]);
        if (faceGap == Double.NEGATIVE_INFINITY || gap > faceGap + allowance(faceGap, size)) {
            faceGap = gap;
            face = i;
            ofFirst = first;
        }
    }

    /** Returns the least gap of the points that it adds; infinite without any. */
    private double clip(Core base, Core other, double margin, double size, Manifold to) {
        double[] e = base.axes;
        double centre = base.component(face, other.x - base.x, other.y - base.y, other.z - base.z);
        double out = centre < 0 ? -1 : 1;
        int s = (face + 1) % 3;
        int t = (face + 2) % 3;
        opposite(base, other, s, t, out);
        cut(0, base.half[s]);
        cut(1, base.half[t]);
        double sign = ofFirst ? -out : out;
        double least = Double.POSITIVE_INFINITY;
        for (int i = 0; i < count; i++) {
            double gap = corners[3 * i + 2] - base.radius - other.radius;
            if (gap <= margin && !repeated(i, SAME * size)) {
                double up = out * (base.half[face] + base.radius + gap / 2);
                double alongS = corners[3 * i];
                double alongT = corners[3 * i + 1];
                to.add(
                        base.x + alongS * e[3 * s] + alongT * e[3 * t] + up * e[3 * face],
                        base.y
                                + alongS * e[3 * s + 1]
                                + alongT * e[3 * t + 1]
                                + up * e[3 * face + 1],
                        base.z
                                + alongS * e[3 * s + 2]
                                + alongT * e[3 * t + 2]
                                + up * e[3 * face + 2],
                        sign * e[3 * face],
                        sign * e[3 * face + 1],
                        sign * e[3 * face + 2],
                        gap);
                least = Math.min(least, gap);
            }
        }
        return least;
    }

    /** The corners of the other's face that looks most at the base's, or of the segment. */
    private void opposite(Core base, Core other, int s, int t, double out) {
        double nx = out * base.axes[3 * face];
        double ny = out * base.axes[3 * face + 1];
        double nz = out * base.axes[3 * face + 2];
        int most = 0;
        for (int i = 1; i < other.dimensions; i++) {
            if (Math.abs(other.component(i, nx, ny, nz))
                    > Math.abs(other.component(most, nx, ny, nz))) {
                most = i;
            }
        }
        boolean down = other.component(most, nx, ny, nz) < 0;
        count = 0;
        if (other.dimensions == 1) {
            corner(base, other, s, t, out, 0);
            corner(base, other, s, t, out, 1);
            return;
        }
        int fixed = down ? 0 : 1 << most;
        int u = 1 << (most + 1) % 3;
        int v = 1 << (most + 2) % 3;
        corner(base, other, s, t, out, fixed);
        corner(base, other, s, t, out, fixed | u);
        corner(base, other, s, t, out, fixed | u | v);
        corner(base, other, s, t, out, fixed | v);
    }

    private void corner(Core base, Core other, int s, int t, double out, int which) {
        other.corner(which);
        double dx = other.cx - base.x;
        double dy = other.cy - base.y;
        double dz = other.cz - base.z;
        corners[3 * count] = base.component(s, dx, dy, dz);
        corners[3 * count + 1] = base.component(t, dx, dy, dz);
        corners[3 * count + 2] = out * base.component(face, dx, dy, dz) - base.half[face];
        count++;
    }

    /** Keeps what lies between -half and half (Sutherland &amp; Hodgman 1974). */
    private void cut(int axis, double half) {
        cut(axis, 1, half);
        cut(axis, -1, half);
    }

    private void cut(int axis, double sign, double half) {
        int kept = 0;
        for (int i = 0; i < count; i++) {
            int here = 3 * i;
            int next = 3 * ((i + 1) % count);
            double inside = half - sign * corners[here + axis];
            double nextInside = half - sign * corners[next + axis];
            if (inside >= 0) {
                System.arraycopy(corners, here, spare, 3 * kept++, 3);
            }
            if ((inside > 0 && nextInside < 0) || (inside < 0 && nextInside > 0)) {
                double share = inside / (inside - nextInside);
                for (int k = 0; k < 3; k++) {
                    double from = corners[here + k];
                    spare[3 * kept + k] = from + share * (corners[next + k] - from);
                }
                kept++;
            }
        }
        double[] old = corners;
        corners = spare;
        spare = old;
        count = kept;
    }

    /** Whether an earlier corner is at the same place: a segment is cut on its way back too. */
    private boolean repeated(int i, double same) {
        for (int j = 0; j < i; j++) {
            double ds = corners[3 * i] - corners[3 * j];
            double dt = corners[3 * i + 1] - corners[3 * j + 1];
            if (Math.abs(ds) <= same && Math.abs(dt) <= same) {
                return true;
            }
        }
        return false;
    }
}
