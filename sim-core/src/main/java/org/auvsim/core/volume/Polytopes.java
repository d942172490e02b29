package org.auvsim.core.volume;

/**
 * Distance of two cores of which at least one is a box. Apart, by the algorithm of Gilbert, Johnson
 * and Keerthi (1988), which here returns the gap between two planes across the best direction it
 * has met: that is never more than the distance, however rounding ends the search. If they overlap,
 * by the direction of least overlap among those that can separate boxes (Gottschalk, Lin &amp;
 * Manocha 1996).
 */
final class Polytopes {
    private static final int MOST_ROUNDS = 40;

    /** Shares of the distance, and of the size, below which a better direction is not sought. */
    private static final double OF_DISTANCE = 1e-14;

    private static final double OF_SIZE = 4e-16;

    /** Rounding of a length that no longer falls, while its direction may still get better. */
    private static final double STALLED = 1e-15;

    static final int ALL_CORNERS = 7;

    private final Difference difference = new Difference();
    private final Simplex simplex = new Simplex();
    private final SeparatingAxis axis = new SeparatingAxis();

    /** Completes {@code to} for the two solids. */
    void measure(Core a, Core b, Separation to) {
        difference.take(a, b);
        axis.search(a, b, difference);
        to.normal(axis.nx, axis.ny, axis.nz);
        if (axis.gap > 0) {
            double distance = approach(axis.gap, Double.POSITIVE_INFINITY, a.reach + b.reach, to);
            to.swell(
                    distance,
                    a.radius,
                    b.radius,
                    a.x + simplex.nearestOfFirst(0),
                    a.y + simplex.nearestOfFirst(1),
                    a.z + simplex.nearestOfFirst(2));
        } else {
            Crossing.locate(a, b, axis.gap, to);
        }
    }

    /**
     * Completes {@code to} for a solid and a triangle of a height map, in the map's coordinates.
     *
     * @param enough if the distance is more (m), how much more does not matter
     * @return which of the triangle's corners the nearest point comes from, a bit each; all three
     *     if the solid's core crosses the triangle
     */
    int measure(Core a, Triangle triangle, double enough, Separation to) {
        difference.take(a, triangle);
        to.normal(triangle.nx, triangle.ny, triangle.nz);
        double distance = approach(Double.NEGATIVE_INFINITY, enough + a.radius, a.reach, to);
        if (distance > 0) {
            to.swell(
                    distance,
                    a.radius,
                    0,
                    a.x + simplex.nearestOfFirst(0),
                    a.y + simplex.nearestOfFirst(1),
                    a.z + simplex.nearestOfFirst(2));
            return simplex.ofTriangle();
        }
        axis.searchUp(a, triangle, difference);
        to.normal(axis.nx, axis.ny, axis.nz);
        Crossing.feature(a, -to.nx, -to.ny, -to.nz);
        to.swell(axis.gap, a.radius, 0, a.cx, a.cy, a.cz);
        return ALL_CORNERS;
    }

    /** Improves the normal until it is that of the nearest points; returns the gap across it. */
    private double approach(double known, double enough, double size, Separation to) {
        double best = known;
        double last = Double.POSITIVE_INFINITY;
        simplex.clear();
        difference.support(to.nx, to.ny, to.nz);
        simplex.add(difference);
        for (int round = 0; round < MOST_ROUNDS; round++) {
            simplex.reduce();
            double length = Math.sqrt(simplex.squared);
            if (!(length > 0 && length <= last * (1 + STALLED))) {
                break;
            }
            last = length;
            double nx = simplex.x / length;
            double ny = simplex.y / length;
            double nz = simplex.z / length;
            double gap = difference.support(nx, ny, nz);
            if (gap > best) {
                best = gap;
                to.normal(nx, ny, nz);
            }
            if (length - gap <= OF_DISTANCE * length + OF_SIZE * size
                    || best > enough
                    || simplex.has(difference.corner)) {
                break;
            }
            simplex.add(difference);
        }
        return best;
    }
}
