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
        double along = d.gap(sign * x, sign * y, sign * z);
        if (along > gap) {
            gap = along;
            nx = sign * x;
            ny = sign * y;
            nz = sign * z;
        }
    }
}
