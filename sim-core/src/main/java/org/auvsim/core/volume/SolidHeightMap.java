package org.auvsim.core.volume;

/**
 * A bounded volume and a height map, in the map's coordinates: the nearest triangle of the surface
 * decides, or if a part's centre is under the surface, the way up out of it.
 *
 * <p>Triangles are looked at only as far off as a few cells: if none is nearer than that, that is
 * the answer, less than the true distance.
 */
final class SolidHeightMap<A extends Volume> implements SolidQuery<A, HeightMap> {
    /** How far, in cells, the surface is searched. */
    private static final double RANGE = 4;

    @Override
    public double distance(A a, Pose poseA, HeightMap b, Pose poseB, Separation to) {
        poseA.seenFrom(poseB, to.seen);
        to.keepFarthest();
        for (int i = 0; i < Core.parts(a); i++) {
            to.first.place(a, i, to.seen);
            measure(to.first, b, to);
        }
        to.restoreKept();
        to.toWorld(poseB);
        return to.distance;
    }

    private static void measure(Core core, HeightMap map, Separation to) {
        Cells cells = to.cells;
        double range = RANGE * map.spacing();
        to.normal(0, 0, 1);
        to.swell(range + core.radius, core.radius, 0, core.x, core.y, core.z);
        to.keepIfLess();
        cells.around(core, range, map);
        cells.triangleAt(core.x, core.y, map, to.triangle);
        if (core.z <= map.height(core.x, core.y)) {
            buried(core, to.triangle, to);
        } else {
            to.polytopes.measure(core, to.triangle, to.keptDistance(), to);
        }
        to.keepIfLess();
        cells.around(core, Math.max(0, to.keptDistance()), map);
        for (int j = cells.firstJ; j <= cells.lastJ; j++) {
            for (int i = cells.firstI; i <= cells.lastI; i++) {
                if (cells.leastDistance(i, j, map) <= Math.max(0, to.keptDistance())) {
                    offer(core, i, j, false, map, to);
                    offer(core, i, j, true, map, to);
                }
            }
        }
    }

    private static void offer(
            Core core, int i, int j, boolean upper, HeightMap map, Separation to) {
        Triangle t = to.triangle;
        double kept = to.keptDistance();
        to.cells.triangle(i, j, upper, map, t);
        boolean mayBeNearer =
                t.gap(core, t.nx, t.ny, t.nz) < kept
                        && (kept <= 0 || t.gap(core, to.keptNx(), to.keptNy(), to.keptNz()) < kept);
        if (mayBeNearer) {
            to.polytopes.measure(core, t, kept, to);
            to.keepIfLess();
        }
    }

    /** A solid whose centre is under a triangle: out along the triangle's normal. */
    static void buried(Core core, Triangle t, Separation to) {
        to.normal(t.nx, t.ny, t.nz);
        double height = t.height(core.x, core.y, core.z);
        double reach = core.along(t.nx, t.ny, t.nz);
        to.swell(
                height - reach,
                core.radius,
                0,
                core.x - reach * t.nx,
                core.y - reach * t.ny,
                core.z - reach * t.nz);
    }

    @Override
    public void manifold(A a, Pose poseA, HeightMap b, Pose poseB, double margin, Manifold to) {
        to.clear();
        Separation nearest = to.nearest;
        poseA.seenFrom(poseB, nearest.seen);
        for (int i = 0; i < Core.parts(a); i++) {
            nearest.first.place(a, i, nearest.seen);
            FloorContacts.add(nearest.first, b, margin, to);
        }
        to.toWorld(poseB);
    }
}
