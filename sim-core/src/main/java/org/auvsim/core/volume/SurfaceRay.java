package org.auvsim.core.volume;

/**
 * Where a ray meets the surface of a height map. Between the lines of the grid and the diagonals of
 * its cells that surface is plane, so that the ray's height above it is linear: from line to line
 * until it is no longer above.
 */
final class SurfaceRay {
    /** The lines of one family that a ray crosses, in order: c = a whole number. */
    private static final class Lines {
        private final double start;
        private final double speed;
        private final int first;
        private final int last;
        private long next;

        /** For c = start + speed t, from {@code t0} on, with lines from first to last. */
        Lines(double start, double speed, int first, int last, double t0) {
            this.start = start;
            this.speed = speed;
            this.first = first;
            this.last = last;
            double c = start + speed * t0;
            next =
                    speed > 0
                            ? Math.max(first, (long) Math.floor(c) + 1)
                            : Math.min(last, (long) Math.ceil(c) - 1);
        }

        /** Where the next line is; infinity behind the last one. */
        double distance() {
            boolean isOver = speed > 0 ? next > last : next < first;
            return speed == 0 || isOver ? Ray.MISS : (next - start) / speed;
        }

        void pass(double t) {
            while (distance() <= t) {
                next += speed > 0 ? 1 : -1;
            }
        }
    }

    private final Ray ray;
    private final HeightMap map;

    SurfaceRay(Ray ray, HeightMap map) {
        this.ray = ray;
        this.map = map;
    }

    /** The distance (m) at which the ray, in the map's coordinates, goes below the surface. */
    double distance() {
        if (above(0) <= 0) {
            return 0;
        }
        double room = ray.from().z() - map.top();
        double fall = -ray.direction().z();
        if (room > 0 && !(fall > 0)) {
            return Ray.MISS;
        }
        return march(room > 0 ? room / fall : 0);
    }

    private double march(double begin) {
        double s = map.spacing();
        double x = ray.from().x() / s;
        double y = ray.from().y() / s;
        double dx = ray.direction().x() / s;
        double dy = ray.direction().y() / s;
        int east = map.columns() - 1;
        int north = map.row().size() - 1;
        Lines columns = new Lines(x, dx, 0, east, begin);
        Lines rows = new Lines(y, dy, 0, north, begin);
        Lines diagonals = new Lines(x - y, dx - dy, -north, east, begin);
        double t0 = begin;
        double above0 = Math.max(0, above(t0));
        while (t0 < ray.range()) {
            double line = Math.min(columns.distance(), rows.distance());
            double t1 = Math.min(ray.range(), Math.min(line, diagonals.distance()));
            double above1 = above(t1);
            if (above1 <= 0) {
                return above0 > 0 ? t0 + (t1 - t0) * (above0 / (above0 - above1)) : t0;
            }
            columns.pass(t1);
            rows.pass(t1);
            diagonals.pass(t1);
            t0 = t1;
            above0 = above1;
        }
        return Ray.MISS;
    }

    private double above(double t) {
        double x = ray.from().x() + t * ray.direction().x();
        double y = ray.from().y() + t * ray.direction().y();
        return ray.from().z() + t * ray.direction().z() - map.height(x, y);
    }
}
