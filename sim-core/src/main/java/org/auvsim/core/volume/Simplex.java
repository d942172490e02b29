package org.auvsim.core.volume;

/**
 * Up to four corners of a {@link Difference} and the point of their hull that is nearest to the
 * origin.
 */
final class Simplex {
    /** Squared sine below which two edges span no plane. */
    private static final double FLAT = 1e-24;

    /**
     * Of faces as near as this, relatively, the one of more corners is taken: to be off the true
     * direction by an angle t makes the distance wrong by t^2 only, but the gap by t.
     */
    private static final double ROUNDING = 1e-15;

    private final double[] w = new double[12];
    private final double[] a = new double[12];
    private final int[] corners = new int[4];
    private int size;

    /** Weights of the points of the best face so far, and which points it has. */
    private final double[] weights = new double[4];

    private int face;

    /** The point nearest to the origin. */
    double x;

    double y;
    double z;

    /** Its squared distance. */
    double squared;

    void clear() {
        size = 0;
    }

    boolean has(int corner) {
        for (int i = 0; i < size; i++) {
            if (corners[i] == corner) {
                return true;
            }
        }
        return false;
    }

    void add(Difference d) {
        int at = 3 * size;
        w[at] = d.wx;
        w[at + 1] = d.wy;
        w[at + 2] = d.wz;
        a[at] = d.ax;
        a[at + 1] = d.ay;
        a[at + 2] = d.az;
        corners[size++] = d.corner;
    }

    /**
     * Finds the nearest point and leaves only the corners that span its face. It is on a face that
     * has the corner added last; each such face gives a candidate if the foot of the perpendicular
     * lies within, so that a thin simplex can mislead none but its thin face.
     */
    void reduce() {
        int last = size - 1;
        squared = Double.POSITIVE_INFINITY;
        point(last);
        for (int i = 0; i < last; i++) {
            edge(i, last);
        }
        for (int i = 0; i < last; i++) {
            for (int j = i + 1; j < last; j++) {
                triangle(i, j, last);
            }
        }
        keepFace();
    }

    private void keepFace() {
        int kept = 0;
        for (int i = 0; i < size; i++) {
            if ((face >> i & 1) != 0) {
                if (kept != i) {
                    System.arraycopy(w, 3 * i, w, 3 * kept, 3);
                    System.arraycopy(a, 3 * i, a, 3 * kept, 3);
                    corners[kept] = corners[i];
                    weights[kept] = weights[i];
                }
                kept++;
            }
        }
        size = kept;
    }

    private void point(int i) {
        if (offer(w[3 * i], w[3 * i + 1], w[3 * i + 2], 1 << i)) {
            weights[i] = 1;
        }
    }

    private void edge(int i, int j) {
        double px = w[3 * i];
        double py = w[3 * i + 1];
        double pz = w[3 * i + 2];
        double ex = w[3 * j] - px;
        double ey = w[3 * j + 1] - py;
        double ez = w[3 * j + 2] - pz;
        double ee = ex * ex + ey * ey + ez * ez;
        double t = -(px * ex + py * ey + pz * ez) / ee;
        if (!(t > 0 && t < 1)) {
            return;
        }
        double vx = px + t * ex;
        double vy = py + t * ey;
        double vz = pz + t * ez;
        // Once more, since near the origin rounding would leave a part along the edge.
        double rest = (vx * ex + vy * ey + vz * ez) / ee;
        if (offer(vx - rest * ex, vy - rest * ey, vz - rest * ez, 1 << i | 1 << j)) {
            weights[i] = 1 - t;
            weights[j] = t;
        }
    }

    private void triangle(int i, int j, int k) {
        double px = w[3 * i];
        double py = w[3 * i + 1];
        double pz = w[3 * i + 2];
        double ex = w[3 * j] - px;
        double ey = w[3 * j + 1] - py;
        double ez = w[3 * j + 2] - pz;
        double fx = w[3 * k] - px;
        double fy = w[3 * k + 1] - py;
        double fz = w[3 * k + 2] - pz;
        double nx = ey * fz - ez * fy;
        double ny = ez * fx - ex * fz;
        double nz = ex * fy - ey * fx;
        double nn = nx * nx + ny * ny + nz * nz;
        double ee = ex * ex + ey * ey + ez * ez;
        double ff = fx * fx + fy * fy + fz * fz;
        if (!(nn > FLAT * ee * ff)) {
            return;
        }
        double s =
                -((py * fz - pz * fy) * nx + (pz * fx - px * fz) * ny + (px * fy - py * fx) * nz)
                        / nn;
        double t =
                -((ey * pz - ez * py) * nx + (ez * px - ex * pz) * ny + (ex * py - ey * px) * nz)
                        / nn;
        if (!(s > 0 && t > 0 && s + t < 1)) {
            return;
        }
        double h = (px * nx + py * ny + pz * nz) / nn;
        if (offer(h * nx, h * ny, h * nz, 1 << i | 1 << j | 1 << k)) {
            weights[i] = 1 - s - t;
            weights[j] = s;
            weights[k] = t;
        }
    }

    private boolean offer(double vx, double vy, double vz, int corners) {
        double vv = vx * vx + vy * vy + vz * vz;
        if (vv > squared * (1 + ROUNDING)) {
            return false;
        }
        squared = vv;
        x = vx;
        y = vy;
        z = vz;
        face = corners;
        return true;
    }

    /** Component {@code k} of the first core's nearest point, less its centre. */
    double nearestOfFirst(int k) {
        double sum = 0;
        for (int i = 0; i < size; i++) {
            sum += weights[i] * a[3 * i + k];
        }
        return sum;
    }

    /** Which corners of the triangle the nearest point comes from, a bit each. */
    int ofTriangle() {
        int met = 0;
        for (int i = 0; i < size; i++) {
            met |= 1 << Difference.ofTriangle(corners[i]);
        }
        return met;
    }
}
