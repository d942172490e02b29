package org.auvsim.diagnosis.residual;

import org.apache.commons.math3.util.ResizableDoubleArray;
import org.auvsim.auvsml.run.LastingError;
import org.auvsim.diagnosis.result.Numbers;
import org.auvsim.diagnosis.run.Channel;
import org.auvsim.diagnosis.run.MeasuredRun;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.stream.Collectors;

/**
 * Errors of measurements that last from one row to the next few, as those of a filtered sensor do,
 * found by the rows alone: third differences of numbers that are h rows apart hold all of an error
 * that is new in each row, whatever h is; of one that lasts the more, the larger h is, until it is
 * forgotten; and of motion by far more still, its variance by h to the sixth. What a sensor leaves
 * out that counts in steps lasts from one step to the next.
 *
 * @param errors by channel and axis, of those that nothing is stated of
 */
record Persistence(List<Lasting> errors) {
    private static final int FARTHEST = 4;

    /** Of fewer differences chance may make any of this. */
    private static final int FEWEST = 300;

    private static final int FEWEST_IN_RUN = 20;

    /** Share of the noise that steps of a sensor may leave out, so that it is no error of these. */
    private static final double MOST_ROUNDED = 0.3;

    /** Five standard deviations of a ratio of two variances are this over the root of how many. */
    private static final double CHANCE = 20;

    /** The square of a step over the variance of what it leaves out. */
    private static final double STEPS = 12;

    /** What a sensor that counts leaves out lasts if a number stays for so many rows on average. */
    private static final double MANY_ROWS = 2;

    /** Of errors no more is in differences of four rows apart than this many times those of two. */
    private static final double MOST_OF_ERRORS = 2;

    /** From row to row so much of an error may stay; what stays for longer may be motion. */
    private static final double MOST_KEPT = 0.85;

    private static final double STEP = 0.01;

    /**
     * Share of the variance seen in differences of successive rows that is new in each at least.
     */
    private static final double LEAST_ANEW = 0.05;

    /** The squares of 1, 3, 3, 1. */
    private static final double THIRD = 20;

    /**
     * An error that lasts.
     *
     * @param axis 0 to 2
     * @param anew standard deviation of what is new in each row
     * @param step in which the sensor counts, if it is of that; else 0
     */
    record Lasting(Channel channel, int axis, LastingError error, double anew, double step) {
        private String words() {
            return step > 0
                    ? "those of the %s, which is told in steps of %s %s, from step to step"
                            .formatted(channel.words(), Numbers.rounded(step), channel.unit())
                    : "those of the %s about %s s"
                            .formatted(channel.words(), Numbers.rounded(error.time()));
        }
    }

    /** The list cannot be changed. */
    Persistence {
        errors = List.copyOf(errors);
    }

    /** Those of runs that were measured with the same sensors. */
    static Persistence of(List<MeasuredRun> runs) {
        List<Lasting> errors = new ArrayList<>();
        for (Channel channel : Channel.values()) {
            errors.addAll(of(runs, channel));
        }
        return new Persistence(errors);
    }

    /** That of an axis (0 to 2) of a channel. */
    Optional<Lasting> of(Channel channel, int axis) {
        return errors.stream().filter(e -> e.channel() == channel && e.axis() == axis).findFirst();
    }

    /** What is to be said of them. */
    Optional<String> notice() {
        return errors.isEmpty()
                ? Optional.empty()
                : Optional.of(
                        "errors last from row to row, as the rows tell, and count as such: "
                                + errors.stream()
                                        .map(Lasting::words)
                                        .distinct()
                                        .collect(Collectors.joining(", ")));
    }

    /** Axes of a channel that are measured as often forget alike. */
    private static List<Lasting> of(List<MeasuredRun> runs, Channel channel) {
        List<OfAxis> axes = new ArrayList<>();
        List<Lasting> errors = new ArrayList<>();
        for (int axis = 0; axis < 3; axis++) {
            List<Series> telling = telling(runs, channel, axis);
            if (!telling.isEmpty()) {
                OfAxis of = new OfAxis(axis, telling);
                if (of.isNoise()) {
                    axes.add(of);
                } else if (of.lasts()) {
                    errors.add(of.ofSteps(channel));
                }
            }
        }
        while (!axes.isEmpty()) {
            OfAxis first = axes.getFirst();
            List<OfAxis> alike = axes.stream().filter(first::isAsOften).toList();
            errors.addAll(of(channel, alike));
            axes.removeAll(alike);
        }
        return errors;
    }

    /** What third differences of an axis say. */
    private static final class OfAxis {
        private final int axis;
        private final Series series;
        private final List<ResizableDoubleArray> differences;
        private final double deviation;
        private final double rounding;
        private final double rowsPerStep;

        OfAxis(int axis, List<Series> all) {
            this.axis = axis;
            series = all.getFirst();
            differences = differences(all);
            deviation = Math.sqrt(variance(differences.getFirst()));
            rounding = all.stream().mapToDouble(Series::rounding).max().orElse(0);
            double rows = all.stream().mapToInt(Series::size).sum();
            rowsPerStep = rows / Math.max(1, all.stream().mapToInt(Series::steps).sum());
        }

        /** Whether what a sensor that counts in steps leaves out is all, and stays for rows. */
        boolean lasts() {
            return rounding > deviation && rowsPerStep > MANY_ROWS;
        }

        /** What it leaves out goes all the way from one side to the other from step to step. */
        Lasting ofSteps(Channel channel) {
            double time = rowsPerStep * interval() / 2;
            return new Lasting(
                    channel,
                    axis,
                    new LastingError(Math.sqrt(1 - LEAST_ANEW) * rounding, time),
                    Math.sqrt(LEAST_ANEW) * rounding,
                    Math.sqrt(STEPS) * rounding);
        }

        /** Whether it has noise, and more than a sensor that counts in steps leaves out. */
        boolean isNoise() {
            return deviation > 0 && rounding < MOST_ROUNDED * deviation;
        }

        boolean isAsOften(OfAxis other) {
            return series.isAsFarApart(other.series);
        }

        double interval() {
            return series.interval().orElseThrow();
        }
    }

    private static List<Lasting> of(Channel channel, List<OfAxis> axes) {
        double[] variances = new double[FARTHEST];
        int count = 0;
        for (int h = 0; h < FARTHEST; h++) {
            ResizableDoubleArray together = new ResizableDoubleArray();
            for (OfAxis of : axes) {
                for (double difference : of.differences.get(h).getElements()) {
                    together.addElement(difference / of.deviation);
                }
            }
            variances[h] = variance(together);
            count = together.getNumElements();
        }
        OptionalDouble kept = count < FEWEST ? OptionalDouble.empty() : kept(variances, count);
        if (kept.isEmpty()) {
            return List.of();
        }
        double lasting = lasting(variances, kept.getAsDouble());
        double anew = Math.max(LEAST_ANEW, anew(variances, kept.getAsDouble(), lasting));
        double time = -axes.getFirst().interval() / StrictMath.log(kept.getAsDouble());
        return axes.stream()
                .map(
                        of ->
                                new Lasting(
                                        channel,
                                        of.axis,
                                        new LastingError(Math.sqrt(lasting) * of.deviation, time),
                                        Math.sqrt(anew) * of.deviation,
                                        0))
                .toList();
    }

    /** Numbers of which nothing is stated, evenly far apart in all runs. */
    private static List<Series> telling(List<MeasuredRun> runs, Channel channel, int axis) {
        List<Series> telling = new ArrayList<>();
        for (MeasuredRun run : runs) {
            Series series = Series.of(run, channel, axis);
            if (!run.lastingErrors(channel, axis).isEmpty() || series.statesDeviations()) {
                return List.of();
            }
            if (series.size() > FEWEST_IN_RUN) {
                telling.add(series);
            }
        }
        boolean areEven =
                telling.stream().allMatch(series -> series.isAsFarApart(telling.getFirst()));
        return areEven ? telling : List.of();
    }

    private static List<ResizableDoubleArray> arrays() {
        List<ResizableDoubleArray> arrays = new ArrayList<>();
        for (int h = 0; h < FARTHEST; h++) {
            arrays.add(new ResizableDoubleArray());
        }
        return arrays;
    }

    /** Sizes of third differences of numbers one row apart, two, and so on. */
    private static List<ResizableDoubleArray> differences(List<Series> all) {
        List<ResizableDoubleArray> differences = arrays();
        for (Series series : all) {
            double[] x = series.levels();
            for (int h = 1; h <= FARTHEST; h++) {
                for (int i = 0; i + 3 * h < x.length; i++) {
                    double third = x[i + 3 * h] - 3 * x[i + 2 * h] + 3 * x[i + h] - x[i];
                    differences.get(h - 1).addElement(Math.abs(third));
                }
            }
        }
        return differences;
    }

    /** The variance of an error that is new in each row and has such differences. */
    private static double variance(ResizableDoubleArray differences) {
        double size = MedianAbsoluteDeviation.standardDeviation(differences.getElements());
        return size * size / THIRD;
    }

    /** How much of an error is left in the next row; empty if none that lasts is told. */
    private static OptionalDouble kept(double[] variances, int count) {
        double chance = CHANCE / Math.sqrt(count);
        boolean lasts = variances[1] > (1 + chance) * variances[0];
        boolean isForgotten = variances[3] < (1 + chance) * MOST_OF_ERRORS * variances[1];
        if (!lasts || !isForgotten) {
            return OptionalDouble.empty();
        }
        double best = STEP;
        for (double kept = STEP; kept < MOST_KEPT; kept += STEP) {
            best = off(variances, kept) < off(variances, best) ? kept : best;
        }
        return off(variances, best) < chance && lasting(variances, best) > 0
                ? OptionalDouble.of(best)
                : OptionalDouble.empty();
    }

    /** Largest share by which a variance is off that of an error that lasts and one that is new. */
    private static double off(double[] variances, double kept) {
        double lasting = lasting(variances, kept);
        double anew = anew(variances, kept, lasting);
        double largest = 0;
        for (int h = 0; h < FARTHEST; h++) {
            double of = anew + lasting * share(StrictMath.pow(kept, h + 1));
            largest = Math.max(largest, Math.abs(of / variances[h] - 1));
        }
        return largest;
    }

    /** Variance of what is new in each row, if all the rest of the first is of what lasts. */
    private static double anew(double[] variances, double kept, double lasting) {
        return Math.max(0, variances[0] - lasting * share(kept));
    }

    /** Variance of what lasts, which makes the first of the variances and the last differ. */
    private static double lasting(double[] variances, double kept) {
        double near = share(kept);
        double far = share(StrictMath.pow(kept, FARTHEST));
        return Math.min(
                variances[0] / near,
                Math.max(0, variances[FARTHEST - 1] - variances[0]) / (far - near));
    }

    /** Of an error that is left so much after h rows: its share in their third differences. */
    private static double share(double left) {
        return 1 - left * (15 - left * (6 - left)) / 10;
    }
}
