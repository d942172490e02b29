package org.auvsim.core.volume;

/**
 * Contact points of a convex solid and a height map, in the map's coordinates: where a corner of
 * the solid is above a triangle, where a peak of the floor is below a face of the solid, and else
 * where the two are nearest.
 */
final class FloorContacts {
    /** A share of the solid's size, below which two points are one. */
    private static final double SAME = 1e-9;

    /** A share of the solid's size, by which a point must be deeper than the others to matter. */
    private static final double CLEARLY = 1e-6;

    /** How far a part of the floor may rise toward the solid and still not be the nearer one. */
    private static final double LEVEL = 1e-9;

    /** The six places of the grid that an edge leads to: di, dj each. */
    private static final int[] NEIGHBOURS = {1, 0, 1, 1, 0, 1, -1, 0, -1, -1, 0, -1};

    private FloorContacts() {}

    /** Adds the points that are no deeper apart than the margin. */
    static void add(Core core, HeightMap map, double margin, Manifold to) {
        Separation nearest = to.nearest;
        Cells cells = nearest.cells;
        cells.around(core, margin, map);
        nearest.keepFarthest();
        for (int j = cells.firstJ; j <= cells.lastJ; j++) {
            for (int i = cells.firstI; i <= cells.lastI; i++) {
                if (cells.leastDistance(i, j, map) <= margin) {
                    triangle(core, i, j, false, map, margin, to);
                    triangle(core, i, j, true, map, margin, to);
                }
            }
        }
        addIfDeeper(core, to);
        if (to.count == 0 && core.z <= map.height(core.x, core.y)) {
            cells.triangleAt(core.x, core.y, map, nearest.triangle);
            SolidHeightMap.buried(core, nearest.triangle, nearest);
            to.add(nearest);
        }
    }

    /**
     * Adds the nearest point of those on level floor: what meets level floor has a corner over it,
     * which says as much, unless the solid crosses the floor.
     */
    private static void addIfDeeper(Core core, Manifold to) {
        Separation nearest = to.nearest;
        int deepest = to.deepest();
        if (nearest.keptDistance() < Double.POSITIVE_INFINITY
                && (deepest < 0
                        || nearest.keptDistance() < to.gap[deepest] - CLEARLY * core.reach)) {
            nearest.restoreKept();
            to.add(nearest);
        }
    }

    private static void triangle(
            Core core, int i, int j, boolean upper, HeightMap map, double margin, Manifold to) {
        Separation nearest = to.nearest;
        Triangle t = nearest.triangle;
        nearest.cells.triangle(i, j, upper, map, t);
        if (t.gap(core, t.nx, t.ny, t.nz) > margin) {
            return;
        }
        int met = nearest.polytopes.measure(core, t, margin, nearest);
        if (nearest.distance > margin) {
            return;
        }
        // What is on the triangle's far side is no contact with it, unless the core crosses it.
        boolean apart = nearest.distance + core.radius > 0;
        double least = apart ? nearest.distance - SAME * core.reach : -2 * core.reach;
        boolean found = corners(core, t, least, margin, to);
        if (core.dimensions == 3) {
            found |= peaks(core, t, map, least, margin, to);
        }
        if (!found) {
            int rise = rise(met, t, nearest, map);
            if (rise == 0) {
                nearest.keepIfLess();
            } else if (rise < 0) {
                once(core, nearest, to);
            }
        }
    }

    /** Corners of the core above the triangle; returns whether there are any. */
    private static boolean corners(
            Core core, Triangle t, double least, double margin, Manifold to) {
        boolean found = false;
        for (int k = 0; k < 1 << core.dimensions; k++) {
            core.corner(k);
            double gap = t.height(core.cx, core.cy, core.cz) - core.radius;
            if (gap <= margin && gap >= least && t.isBelow(core.cx, core.cy, core.cz)) {
                double back = core.radius + gap / 2;
                once(
                        core,
                        core.cx - back * t.nx,
                        core.cy - back * t.ny,
                        core.cz - back * t.nz,
                        t.nx,
                        t.ny,
                        t.nz,
                        gap,
                        to);
                found = true;
            }
        }
        return found;
    }

    /** Corners of the triangle that rise over their neighbours, below the lowest face of a box. */
    private static boolean peaks(
            Core core, Triangle t, HeightMap map, double least, double margin, Manifold to) {
        int face = lowestFace(core, t);
        double sign = core.component(face, t.nx, t.ny, t.nz) < 0 ? -1 : 1;
        boolean found = false;
        for (int k = 0; k < 3; k++) {
            double dx = t.corners[3 * k] - core.x;
            double dy = t.corners[3 * k + 1] - core.y;
            double dz = t.corners[3 * k + 2] - core.z;
            double gap = -sign * core.component(face, dx, dy, dz) - core.half[face];
            int s = (face + 1) % 3;
            int u = (face + 2) % 3;
            if (gap <= margin
                    && gap >= least
                    && Math.abs(core.component(s, dx, dy, dz)) <= core.half[s]
                    && Math.abs(core.component(u, dx, dy, dz)) <= core.half[u]
                    && rises(t.places[2 * k], t.places[2 * k + 1], map)) {
                double nx = sign * core.axes[3 * face];
                double ny = sign * core.axes[3 * face + 1];
                double nz = sign * core.axes[3 * face + 2];
                once(
                        core,
                        t.corners[3 * k] + gap / 2 * nx,
                        t.corners[3 * k + 1] + gap / 2 * ny,
                        t.corners[3 * k + 2] + gap / 2 * nz,
                        nx,
                        ny,
                        nz,
                        gap,
                        to);
                found = true;
            }
        }
        return found;
    }

    private static int lowestFace(Core core, Triangle t) {
        int face = 0;
        for (int i = 1; i < 3; i++) {
            if (Math.abs(core.component(i, t.nx, t.ny, t.nz))
                    > Math.abs(core.component(face, t.nx, t.ny, t.nz))) {
                face = i;
            }
        }
        return face;
    }

    /** Whether the surface bulges at a place of the grid, along x, y or the diagonal. */
    private static boolean rises(int i, int j, HeightMap map) {
        double here = map.sample(i, j);
        double most = 0;
        for (int k = 0; k < 6; k += 2) {
            int di = NEIGHBOURS[k];
            int dj = NEIGHBOURS[k + 1];
            double mean = (map.sample(i + di, j + dj) + map.sample(i - di, j - dj)) / 2;
            most = Math.max(most, here - mean);
        }
        return most > LEVEL * map.spacing();
    }

    /**
     * How the surface beside the nearest point goes on, as seen from the solid: above 0 if some of
     * it leads nearer, 0 if all is level, below 0 if it is a ridge or the rim of one. A flat floor
     * has no contacts of their own at the edges of its triangles.
     */
    private static int rise(int met, Triangle t, Separation s, HeightMap map) {
        int k = Integer.numberOfTrailingZeros(met);
        int i = t.places[2 * k];
        int j = t.places[2 * k + 1];
        int rise = 0;
        for (int n = 0; n < 12 && rise <= 0 && met != Polytopes.ALL_CORNERS; n += 2) {
            int ni = i + NEIGHBOURS[n];
            int nj = j + NEIGHBOURS[n + 1];
            if (isBesideAll(ni, nj, met, t)) {
                double slope = slope(ni, nj, s, map);
                rise = slope > LEVEL ? 1 : slope < -LEVEL ? -1 : rise;
            }
        }
        return rise;
    }

    /** Whether a place of the grid makes a triangle with the corners that are met. */
    private static boolean isBesideAll(int i, int j, int met, Triangle t) {
        for (int k = 0; k < 3; k++) {
            if ((met >> k & 1) != 0) {
                int di = i - t.places[2 * k];
                int dj = j - t.places[2 * k + 1];
                boolean same = di == 0 && dj == 0;
                if (same || Math.abs(di) > 1 || Math.abs(dj) > 1 || di * dj < 0) {
                    return false;
                }
            }
        }
        return true;
    }

    /** Sine of the angle at which a place of the grid lies above the nearest point. */
    private static double slope(int i, int j, Separation s, HeightMap map) {
        double dx = s.cells.x(i) - (s.px - s.nx * s.distance / 2);
        double dy = s.cells.y(j) - (s.py - s.ny * s.distance / 2);
        double dz = map.sample(i, j) - (s.pz - s.nz * s.distance / 2);
        double length = Math.sqrt(dx * dx + dy * dy + dz * dz);
        return (dx * s.nx + dy * s.ny + dz * s.nz) / length;
    }

    private static void once(Core core, Separation s, Manifold to) {
        once(core, s.px, s.py, s.pz, s.nx, s.ny, s.nz, s.distance, to);
    }

    /** Adds a point unless it is there already: triangles share their corners and edges. */
    private static void once(
            Core core,
            double x,
            double y,
            double z,
            double nx,
            double ny,
            double nz,
            double gap,
            Manifold to) {
        double same = SAME * core.reach;
        for (int i = 0; i < to.count; i++) {
            if (Math.abs(to.x[i] - x) <= same
                    && Math.abs(to.y[i] - y) <= same
                    && Math.abs(to.z[i] - z) <= same) {
                return;
            }
        }
        to.add(x, y, z, nx, ny, nz, gap);
    }
}
