package org.auvsim.core.volume;

/** Where two cores that overlap meet along the direction of least overlap. */
final class Crossing {
    /** Cosine below which an edge is across the direction, so that all of it is met. */
    private static final double ACROSS = 1e-9;

    private Crossing() {}

    /** Completes {@code to}, which has the normal, for two solids whose cores have this gap. */
    static void locate(Core a, Core b, double gap, Separation to) {
        int edgesA = feature(a, -to.nx, -to.ny, -to.nz);
        int edgesB = feature(b, to.nx, to.ny, to.nz);
        int metA = Integer.bitCount(edgesA);
        int metB = Integer.bitCount(edgesB);
        if (metA == 1 && metB == 1) {
            toCrossing(a, Integer.numberOfTrailingZeros(edgesA), b, edgesB);
        }
        boolean byFirst = metA < metB || (metA == metB && a.reach <= b.reach);
        if (byFirst) {
            to.swell(gap, a.radius, b.radius, a.cx, a.cy, a.cz);
        } else {
            to.swell(
                    gap,
                    a.radius,
                    b.radius,
                    b.cx + gap * to.nx,
                    b.cy + gap * to.ny,
                    b.cz + gap * to.nz);
        }
    }

    /**
     * Puts the middle of the face, edge or corner that is farthest along a unit vector into cx, cy,
     * cz; returns which edges span it, a bit each.
     */
    static int feature(Core core, double nx, double ny, double nz) {
        int edges = 0;
        core.cx = core.x;
        core.cy = core.y;
        core.cz = core.z;
        for (int i = 0; i < core.dimensions; i++) {
            double cosine = core.component(i, nx, ny, nz);
            if (Math.abs(cosine) < ACROSS) {
                edges |= 1 << i;
            } else {
                core.move(i, Math.copySign(core.half[i], cosine));
            }
        }
        return edges;
    }

    /** Moves the middle of an edge of {@code a} along it to where an edge of {@code b} crosses. */
    private static void toCrossing(Core a, int i, Core b, int edgesB) {
        int j = Integer.numberOfTrailingZeros(edgesB);
        double dx = a.cx - b.cx;
        double dy = a.cy - b.cy;
        double dz = a.cz - b.cz;
        double cosine = a.component(i, b.axes[3 * j], b.axes[3 * j + 1], b.axes[3 * j + 2]);
        double sineSquared = 1 - cosine * cosine;
        if (sineSquared > 0) {
            double s =
                    (cosine * b.component(j, dx, dy, dz) - a.component(i, dx, dy, dz))
                            / sineSquared;
            double t =
                    (b.component(j, dx, dy, dz) - cosine * a.component(i, dx, dy, dz))
                            / sineSquared;
            a.move(i, Math.max(-a.half[i], Math.min(a.half[i], s)));
            b.move(j, Math.max(-b.half[j], Math.min(b.half[j], t)));
        }
    }
}
