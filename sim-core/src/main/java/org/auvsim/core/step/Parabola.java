package org.auvsim.core.step;

import org.auvsim.core.math.Vec3;

import java.util.function.DoubleUnaryOperator;

/**
 * A path under a constant force, or the difference of two.
 *
 * @param place at the beginning (m)
 * @param velocity there (m/s)
 * @param acceleration (m/s^2)
 */
record Parabola(Vec3 place, Vec3 velocity, Vec3 acceleration) {
    /** Halvings after which an interval is as narrow as numbers are. */
    private static final int HALVINGS = 80;

    Parabola minus(Parabola o) {
        return new Parabola(
                place.minus(o.place),
                velocity.minus(o.velocity),
                acceleration.minus(o.acceleration));
    }

    Vec3 at(double t) {
        return place.plus(velocity.plus(acceleration.times(t / 2)).times(t));
    }

    /**
     * The instants in (0, end) at which the distance from the origin is least or greatest, in
     * order, and {@code end}; between two of them it only falls or only grows.
     */
    double[] extremes(double end) {
        // Half the derivative of the squared distance, a cubic, and where that turns itself.
        double c3 = acceleration.dot(acceleration) / 2;
        double c2 = 1.5 * velocity.dot(acceleration);
        double c1 = velocity.dot(velocity) + place.dot(acceleration);
        double[] turns = new double[] {0, end, end};
        double root = Math.sqrt(c2 * c2 - 3 * c3 * c1);
        double stable = -(c2 + Math.copySign(root, c2));
        double one = within(stable / (3 * c3), end);
        double other = within(c1 / stable, end);
        turns[0] = Math.min(one, other);
        turns[1] = Math.max(one, other);
        double[] extremes = new double[] {end, end, end, end};
        int count = 0;
        double before = 0;
        for (double turn : turns) {
            if (slope(before) > 0 != slope(turn) > 0) {
                extremes[count++] = signChange(this::slope, before, turn);
            }
            before = turn;
        }
        return extremes;
    }

    /** The instant itself if it lies inside the interval from 0 on, else the interval's end. */
    private static double within(double instant, double end) {
        return instant > 0 && instant < end ? instant : end;
    }

    private double slope(double t) {
        return at(t).dot(velocity.plus(acceleration.times(t)));
    }

    /**
     * When the distance from the origin falls to {@code reach}, in an interval in which it only
     * falls or only grows; infinity if it does not.
     */
    double comesWithin(double reach, double from, double to) {
        DoubleUnaryOperator gap = t -> at(t).dot(at(t)) - reach * reach;
        return gap.applyAsDouble(from) > 0 && gap.applyAsDouble(to) <= 0
                ? signChange(gap, from, to)
                : Double.POSITIVE_INFINITY;
    }

    /** The upper end of the last interval, in which the function's being positive changes. */
    private static double signChange(DoubleUnaryOperator function, double from, double to) {
        boolean before = function.applyAsDouble(from) > 0;
        double low = from;
        double high = to;
        for (int i = 0; i < HALVINGS; i++) {
            double middle = (low + high) / 2;
            if (function.applyAsDouble(middle) > 0 == before) {
                low = middle;
            } else {
                high = middle;
            }
        }
        return high;
    }
}
