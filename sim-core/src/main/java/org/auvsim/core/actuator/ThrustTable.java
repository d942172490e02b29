package org.auvsim.core.actuator;

import org.auvsim.core.description.Unit;
import org.auvsim.core.entity.Domain;

import java.util.List;

/**
 * Thrust by a table of measured points: straight lines between them, constant beyond the first and
 * the last.
 *
 * @param thrustPoint the points, in order of level
 */
public record ThrustTable(List<ThrustPoint> thrustPoint) implements ThrustCurve {
    /** A table that pushes harder than this share of its greatest thrust at level 0 is refused. */
    private static final double MOST_AT_REST = 1e-9;

    /** At {@code level}, -1 to 1, the propulsor pushes with {@code thrust} (N). */
    public record ThrustPoint(double level, @Unit("N") double thrust) {}

    /**
     * A checked table.
     *
     * @throws IllegalArgumentException if it has fewer than two points, a level is outside [-1, 1]
     *     or not above that of the point before, a thrust is not finite, or it pushes at level 0
     */
    public ThrustTable {
        thrustPoint = List.copyOf(thrustPoint);
        if (thrustPoint.size() < 2) {
            throw new IllegalArgumentException(
                    "a thrust table needs at least 2 points, but has " + thrustPoint.size());
        }
        double greatest = 0;
        for (int i = 0; i < thrustPoint.size(); i++) {
            String of = "point " + (i + 1) + " of a thrust table";
            Domain.within(of, "level", -1, 1, thrustPoint.get(i).level, "");
            Domain.finite(of, "thrust", thrustPoint.get(i).thrust, "N");
            greatest = Math.max(greatest, Math.abs(thrustPoint.get(i).thrust));
            if (i > 0 && !(thrustPoint.get(i).level > thrustPoint.get(i - 1).level)) {
                throw new IllegalArgumentException(
                        "point %d of a thrust table has level %s, which is not above the %s of point %d;"
                                        .formatted(
                                                i + 1,
                                                thrustPoint.get(i).level,
                                                thrustPoint.get(i - 1).level,
                                                i)
                                + " put them in order of level, each level once");
            }
        }
        double atRest = thrust(thrustPoint, 0);
        if (Math.abs(atRest) > MOST_AT_REST * greatest) {
            throw new IllegalArgumentException(
                    "a thrust table must give 0 N at level 0, but gives " + atRest + " N");
        }
    }

    @Override
    public double thrust(double level) {
        return thrust(thrustPoint, level);
    }

    private static double thrust(List<ThrustPoint> points, double level) {
        if (level <= points.getFirst().level) {
            return points.getFirst().thrust;
        }
        if (level >= points.getLast().level) {
            return points.getLast().thrust;
        }
        int below = 0;
        int above = points.size() - 1;
        while (above - below > 1) {
            int middle = (below + above) >>> 1;
            if (points.get(middle).level <= level) {
                below = middle;
            } else {
                above = middle;
            }
        }
        ThrustPoint a = points.get(below);
        ThrustPoint b = points.get(above);
        return a.thrust + (b.thrust - a.thrust) * (level - a.level) / (b.level - a.level);
    }
}
