package org.auvsim.core.volume;

/** Contact points of two capsules: two where they lie side by side, else one. */
final class ParallelSegments {
    /** Squared sine of the angle up to which two capsules may touch along a line. */
    private static final double NEAR_PARALLEL = 0.01;

    /** A share of the lengths: a shorter stretch side by side is a point. */
    private static final double SHORT = 1e-6;

    private ParallelSegments() {}

    /** Adds the points, given the two solids' separation in the manifold. */
    static void touch(Core a, Core b, double margin, Manifold to) {
        double cosine = a.component(0, b.axes[0], b.axes[1], b.axes[2]);
        double middle = a.component(0, b.x - a.x, b.y - a.y, b.z - a.z);
        double reach = b.half[0] * Math.abs(cosine);
        double from = Math.max(-a.half[0], middle - reach);
        double till = Math.min(a.half[0], middle + reach);
        double size = a.half[0] + b.half[0];
        if (1 - cosine * cosine > NEAR_PARALLEL || till - from < SHORT * size) {
            to.add(to.nearest);
            return;
        }
        double least = Math.min(at(a, b, from, margin, to), at(a, b, till, margin, to));
        if (to.nearest.distance < least - SHORT * size) {
            to.add(to.nearest);
        }
    }

    /** Adds the point of {@code a} at {@code s} along its axis, if near; returns its gap. */
    private static double at(Core a, Core b, double s, double margin, Manifold to) {
        double px = a.x + s * a.axes[0];
        double py = a.y + s * a.axes[1];
        double pz = a.z + s * a.axes[2];
        double along = b.component(0, px - b.x, py - b.y, pz - b.z);
        double t = Math.max(-b.half[0], Math.min(b.half[0], along));
        double dx = px - b.x - t * b.axes[0];
        double dy = py - b.y - t * b.axes[1];
        double dz = pz - b.z - t * b.axes[2];
        double length = Math.sqrt(dx * dx + dy * dy + dz * dz);
        double gap = length - a.radius - b.radius;
        if (gap > margin || !(length > 0)) {
            return Double.POSITIVE_INFINITY;
        }
        double nx = dx / length;
        double ny = dy / length;
        double nz = dz / length;
        double back = a.radius + gap / 2;
        to.add(px - back * nx, py - back * ny, pz - back * nz, nx, ny, nz, gap);
        return gap;
    }
}
