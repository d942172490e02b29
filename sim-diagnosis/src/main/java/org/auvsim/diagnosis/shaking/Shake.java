package org.auvsim.diagnosis.shaking;

import org.apache.commons.math3.stat.descriptive.rank.Median;
import org.auvsim.diagnosis.model.BelievedModel;
import org.auvsim.diagnosis.run.MeasuredRun;

import java.util.Arrays;
import java.util.Optional;
import java.util.function.IntToDoubleFunction;
import java.util.stream.IntStream;

/**
 * How much a body shakes along a run, for its thrust. Second differences over three rows hardly
 * contain motion: what is left of an accelerometer and a gyro is their noise, which is not the
 * same, and what shakes both. That is their covariance. A rotor out of balance pushes with the
 * square of its speed, as thrust grows: accelerations with the thrust T, rates, which are those
 * over the speed, with its root, so that the covariance is in proportion to T^1.5.
 *
 * @param strength covariance of the second differences, each by the root of 6 (1, 2, 1 squared),
 *     for each T^1.5 (N^1.5); in the units of the two sensors
 * @param interval the usual time between two rows (s)
 */
record Shake(double strength, double interval) {
    /** Rows tell of shaking at this share of the largest thrust or more. */
    private static final double PUSHING = 0.5;

    /** Fewer rows tell nothing. */
    private static final int FEWEST = 16;

    /** Intervals that differ by less than this share are the same. */
    static final double SAME = 0.1;

    /** Of the thrust, in the covariance. */
    private static final double POWER = 1.5;

    /** 1, 2 and 1, squared: by so much a second difference has more variance than its rows. */
    private static final double SQUARES = 6;

    /** That of a run; empty if too few rows tell of it. */
    static Optional<Shake> of(MeasuredRun run, BelievedModel model) {
        double[] thrust = new ToldThrust(model.variant().body()).along(run);
        double least = PUSHING * Arrays.stream(thrust).max().orElse(0);
        double products = 0;
        double scale = 0;
        int rows = 0;
        for (int k = 1; k < run.size() - 1; k++) {
            double product =
                    secondDifference(run::acceleration, k) * secondDifference(run::rate, k);
            boolean pushes = thrust[k] > 0 && thrust[k] >= least;
            boolean isSteady = thrust[k - 1] == thrust[k] && thrust[k] == thrust[k + 1];
            if (!Double.isNaN(product) && pushes && isSteady && isEven(run, k)) {
                products += product / SQUARES;
                scale += StrictMath.pow(thrust[k], POWER);
                rows++;
            }
        }
        return rows < FEWEST
                ? Optional.empty()
                : Optional.of(new Shake(products / scale, interval(run)));
    }

    private static double secondDifference(IntToDoubleFunction of, int k) {
        return of.applyAsDouble(k - 1) - 2 * of.applyAsDouble(k) + of.applyAsDouble(k + 1);
    }

    private static boolean isEven(MeasuredRun run, int sample) {
        double before = run.time(sample) - run.time(sample - 1);
        double after = run.time(sample + 1) - run.time(sample);
        return isSame(before, after);
    }

    private static double interval(MeasuredRun run) {
        return new Median()
                .evaluate(
                        IntStream.range(1, run.size())
                                .mapToDouble(k -> run.time(k) - run.time(k - 1))
                                .toArray());
    }

    /** Whether two intervals are the same but for rounding. */
    static boolean isSame(double one, double other) {
        return Math.abs(one - other) <= SAME * Math.min(one, other);
    }
}
