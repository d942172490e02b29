package org.auvsim.core.volume;

/**
 * The direction along which two cores, of which at least one is a box, are farthest apart or
 * overlap least: a face's normal or a cross product of edges (Gottschalk, Lin &amp; Manocha 1996).
 */
final class SeparatingAxis {
    /**
     * Squared sine below which edges are parallel to rounding: a direction that rounding has turned
     * does no harm, since the gap is measured along it as it is, but one of length 0 would.
     */
    private static final double PARALLEL = 1e-28;

    /** Least cosine between a triangle's normal and a way up out of it. */
    private static final double STEEPEST = 0.5;

    /** Unit vector from the second core to the first. */
    double nx;

    double ny;
    double nz;

    /** Gap along it (m); negative if the cores overlap. */
    double gap;

    /** Finds the best direction; once one separates the cores, only as good as it happens to be. */
    void search(Core a, Core b, Difference d) {
        gap = Double.NEGATIVE_INFINITY;
        faces(a, d);
        faces(b, d);
        for (int i = 0; i < a.dimensions && gap <= 0; i++) {
            for (int j = 0; j < b.dimensions; j++) {
                edges(a.axes, 3 * i, b.axes, 3 * j, d);
            }
        }
    }

    /**
     * Finds the way up out of a triangle, for a core that crosses it: along its normal, or one that
     * does not lean far from it.
     */
    void searchUp(Core a, Triangle t, Difference d) {
        gap = Double.NEGATIVE_INFINITY;
        offerUp(t.nx, t.ny, t.nz, t, d);
        for (int i = 0; a.dimensions == 3 && i < 9; i += 3) {
            offerUp(a.axes[i], a.axes[i + 1], a.axes[i + 2], t, d);
        }
        for (int i = 0; i < a.dimensions; i++) {
            for (int k = 0; k < 3; k++) {
                int from = 3 * k;
                int to = 3 * ((k + 1) % 3);
                double ex = t.corners[to] - t.corners[from];
                double ey = t.corners[to + 1] - t.corners[from + 1];
                double ez = t.corners[to + 2] - t.corners[from + 2];
                double ux = a.axes[3 * i];
                double uy = a.axes[3 * i + 1];
                double uz = a.axes[3 * i + 2];
                double x = ey * uz - ez * uy;
                double y = ez * ux - ex * uz;
                double z = ex * uy - ey * ux;
                double length = Math.sqrt(x * x + y * y + z * z);
                if (length > 0) {
                    offerUp(x / length, y / length, z / length, t, d);
                }
            }
        }
    }

    private void offerUp(double x, double y, double z, Triangle t, Difference d) {
        double cosine = x * t.nx + y * t.ny + z * t.nz;
        if (Math.abs(cosine) > STEEPEST) {
            double sign = cosine < 0 ? -1 : 1;
            take(sign * x, sign * y, sign * z, d);
        }
    }

    private void faces(Core core, Difference d) {
        if (core.dimensions == 3) {
            for (int i = 0; i < 9; i += 3) {
                offer(core.axes[i], core.axes[i + 1], core.axes[i + 2], d);
            }
        }
    }

    private void edges(double[] u, int i, double[] v, int j, Difference d) {
        double x = u[i + 1] * v[j + 2] - u[i + 2] * v[j + 1];
        double y = u[i + 2] * v[j] - u[i] * v[j + 2];
        double z = u[i] * v[j + 1] - u[i + 1] * v[j];
        double squared = x * x + y * y + z * z;
        if (squared > PARALLEL) {
            double k = 1 / Math.sqrt(squared);
            offer(k * x, k * y, k * z, d);
        }
    }

    private void offer(double x, double y, double z, Difference d) {
        double sign = x * d.x + y * d.y + z * d.z < 0 ? -1 : 1;
        take(sign * x, sign * y, sign * z, d);
    }

    private void take(double x, double y, double z, Difference d) {
        double along = d.gap(x, y, z);
        if (along > gap) {
            gap = along;
            nx = x;
            ny = y;
            nz = z;
        }
    }
}
