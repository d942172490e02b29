package org.auvsim.diagnosis.field;

import org.auvsim.core.math.Vec3;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;

/**
 * A cubic grid through the origin of the world.
 *
 * @param spacing between neighbours (m)
 */
record Grid(double spacing) {
    /** A point of the grid, in spacings. */
    private record Point(long x, long y, long z) {
        static final Comparator<Point> ORDER =
                Comparator.comparingLong(Point::x)
                        .thenComparingLong(Point::y)
                        .thenComparingLong(Point::z);
    }

    /** All its points that are no farther (m) from any of some places, in order. */
    List<Vec3> within(double distance, List<Vec3> places) {
        Set<Point> points = new TreeSet<>(Point.ORDER);
        int reach = (int) Math.ceil(distance / spacing);
        for (Vec3 place : places) {
            Point near = new Point(nearest(place.x()), nearest(place.y()), nearest(place.z()));
            for (long x = near.x() - reach; x <= near.x() + reach; x++) {
                for (long y = near.y() - reach; y <= near.y() + reach; y++) {
                    for (long z = near.z() - reach; z <= near.z() + reach; z++) {
                        Point point = new Point(x, y, z);
                        if (at(point).minus(place).norm() <= distance) {
                            points.add(point);
                        }
                    }
                }
            }
        }
        List<Vec3> all = new ArrayList<>();
        points.forEach(point -> all.add(at(point)));
        return all;
    }

    private long nearest(double coordinate) {
        return Math.round(coordinate / spacing);
    }

    private Vec3 at(Point point) {
        return new Vec3(point.x() * spacing, point.y() * spacing, point.z() * spacing);
    }
}
