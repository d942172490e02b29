package org.auvsim.diagnosis.residual;

import org.apache.commons.math3.stat.regression.OLSMultipleLinearRegression;

import java.util.Arrays;
import java.util.List;
import java.util.stream.IntStream;

/**
 * Numbers that are off together, two or three in a row and to one side: a sensor was misled for a
 * moment. No body jumps aside and back, so that numbers before and after them lie on one line, or
 * at least one parabola, that passes them by. Where a body bounces or is pushed, they do not.
 */
final class Bursts {
    private static final int LONGEST = 3;

    /** One alone is found by a cubic, if so many numbers come before it and after. */
    private static final int NOT_ALONE = 2;

    /** So many numbers before and after are looked at, and so many at least of both together. */
    private static final int BESIDE = 5;

    private static final int FEWEST_BESIDE = 6;

    /**
     * A curve that is taken through the numbers beside.
     *
     * @param degree of the polynomial
     * @param far by how many standard deviations each number between must be off it
     * @param alike by so many at most they may differ
     */
    private record Curve(int degree, double far, double alike) {}

    /** A parabola follows half of a kink, so that more is asked of its numbers. */
    private static final List<Curve> CURVES =
            List.of(new Curve(1, 5, Double.POSITIVE_INFINITY), new Curve(2, 10, 4));

    /** Where nothing follows, or comes before, a kink goes on; what is aside stays so. */
    private static final List<Curve> AT_THE_END = List.of(new Curve(1, 5, 4), new Curve(2, 6, 4));

    /** Numbers beside are noise if their squares are no more than this deviate (1 in 100). */
    private static final double MOST_BESIDE = 2.3;

    private final Series series;
    private final double[] levels;
    private final double noise;
    private final double scale;

    private Bursts(Series series, double noise, double scale) {
        this.series = series;
        this.noise = noise;
        this.scale = scale;
        levels = series.levels();
    }

    /**
     * By how many standard deviations each number is off, 0 of those that are in no burst.
     *
     * @param noise standard deviation of numbers of which the run states none
     * @param scale by how many times all of them are larger than that
     */
    static double[] off(Series series, double noise, double scale) {
        return new Bursts(series, noise, scale).off();
    }

    private double[] off() {
        double[] off = new double[levels.length];
        for (int length = 1; length <= LONGEST; length++) {
            for (int first = 0; first + length <= levels.length; first++) {
                if (jumps(first, length)) {
                    double[] of = off(first, length);
                    System.arraycopy(of, 0, off, first, of.length);
                }
            }
        }
        return off;
    }

    /**
     * Whether it may be one: what comes next is cheap to ask of few. The first number alone, and
     * the last, may as well be where a motion changes.
     */
    private boolean jumps(int first, int length) {
        int next = first + length;
        boolean isAlone = length == 1;
        if (isAtEnd(first, length)) {
            return !isAlone;
        }
        if (isAlone && first >= NOT_ALONE && next + NOT_ALONE <= levels.length) {
            return false;
        }
        double jump = levels[first] - levels[first - 1] + levels[next - 1] - levels[next];
        return Math.abs(jump)
                > CURVES.getFirst().far() * Math.min(deviation(first), deviation(next - 1));
    }

    private boolean isAtEnd(int first, int length) {
        return first == 0 || first + length == levels.length;
    }

    /** By how much its numbers are off; none if they are no burst. */
    private double[] off(int first, int length) {
        int next = first + length;
        int after = levels.length - next;
        int lacking =
                Math.max(0, FEWEST_BESIDE - Math.min(first, BESIDE) - Math.min(after, BESIDE));
        int[] beside =
                IntStream.range(
                                Math.max(0, first - BESIDE - lacking),
                                Math.min(levels.length, next + BESIDE + lacking))
                        .filter(i -> i < first || i >= next)
                        .toArray();
        if (beside.length < FEWEST_BESIDE) {
            return new double[0];
        }
        for (Curve curve : isAtEnd(first, length) ? AT_THE_END : CURVES) {
            double[] off = off(first, length, beside, curve);
            if (off.length > 0) {
                return off;
            }
        }
        return new double[0];
    }

    private double[] off(int first, int length, int[] beside, Curve curve) {
        OLSMultipleLinearRegression fit = new OLSMultipleLinearRegression();
        fit.setNoIntercept(true);
        double[][] rows = new double[beside.length][];
        double[] values = new double[beside.length];
        for (int k = 0; k < beside.length; k++) {
            double weight = 1 / deviation(beside[k]);
            double[] powers = powers(beside[k], first, curve);
            rows[k] = Arrays.stream(powers).map(power -> weight * power).toArray();
            values[k] = weight * (levels[beside[k]] - levels[first]);
        }
        fit.newSampleData(values, rows);
        int freedom = beside.length - curve.degree() - 1;
        if (Whiteness.deviate(Outcome.squares(fit.estimateResiduals()), freedom) > MOST_BESIDE) {
            return new double[0];
        }
        double[] coefficients = fit.estimateRegressionParameters();
        double[][] spread = fit.estimateRegressionParametersVariance();
        double[] plain = new double[length];
        double[] off = new double[length];
        for (int k = 0; k < length; k++) {
            double[] powers = powers(first + k, first, curve);
            double deviation = deviation(first + k);
            double variance = deviation * deviation;
            for (int p = 0; p < powers.length; p++) {
                variance += powers[p] * product(spread[p], powers);
            }
            double by = levels[first + k] - levels[first] - product(coefficients, powers);
            plain[k] = by / deviation;
            off[k] = by / Math.sqrt(variance);
        }
        boolean isBurst =
                (min(off) > curve.far() || max(off) < -curve.far())
                        && max(plain) - min(plain) < curve.alike();
        return isBurst ? off : new double[0];
    }

    private static double min(double[] values) {
        return Arrays.stream(values).min().orElseThrow();
    }

    private static double max(double[] values) {
        return Arrays.stream(values).max().orElseThrow();
    }

    private double deviation(int i) {
        double stated = series.stated(i);
        return scale * (Double.isNaN(stated) ? noise : stated);
    }

    /** Powers of the time of a number since another one, in their mean intervals. */
    private double[] powers(int i, int since, Curve curve) {
        double interval = (series.time(levels.length - 1) - series.time(0)) / (levels.length - 1);
        double time = (series.time(i) - series.time(since)) / interval;
        return IntStream.rangeClosed(0, curve.degree())
                .mapToDouble(p -> p == 0 ? 1 : p == 1 ? time : time * time)
                .toArray();
    }

    private static double product(double[] a, double[] b) {
        double sum = 0;
        for (int i = 0; i < a.length; i++) {
            sum += a[i] * b[i];
        }
        return sum;
    }
}
