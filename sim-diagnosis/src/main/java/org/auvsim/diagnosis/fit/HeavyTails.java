package org.auvsim.diagnosis.fit;

import org.auvsim.core.math.Quat;
import org.auvsim.diagnosis.run.Channel;
import org.auvsim.diagnosis.run.MeasuredRun;

import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.StringJoiner;

/**
 * Takes their power from outliers: where a channel has more numbers far off than a normal
 * distribution has, each is weighed as under Student's t with few degrees of freedom (Lange, Little
 * &amp; Taylor 1989), by how far it is off a cubic through its four neighbours: without any model.
 */
final class HeavyTails {
    private static final double FREEDOM = 4;

    /** This far off (in standard deviations) 6 of 100,000 normally distributed numbers are. */
    private static final double FAR = 4;

    private static final double MOST_FAR = 0.002;
    private static final int MOST_BY_CHANCE = 1;

    /** This far off no normally distributed number is. */
    private static final double ASTRAY = 6;

    /** Of fourth differences (1, 4, 6, 4, 1), the middle one taken once. */
    private static final double[] CUBIC = {1 / 6.0, -4 / 6.0, 1, -4 / 6.0, 1 / 6.0};

    private static final double SPREAD = Math.sqrt(70) / 6;

    private HeavyTails() {}

    /** What motions miss of a run, outliers weighed less where there are many. */
    static Misses tamed(Misses of, Noise noise) {
        int rows = of.rows().size();
        double[] factors = new double[of.run().size() * rows];
        Arrays.fill(factors, 1);
        for (int row = 0; row < rows; row++) {
            Misses.Row which = of.rows().get(row);
            double scale = noise.of(which.channel(), which.axis()) * SPREAD;
            if (hasOutliers(of.run(), which, scale)) {
                for (int k = 2; k + 2 < of.run().size(); k++) {
                    double z = off(of.run(), which, k) / scale;
                    factors[k * rows + row] = factor(z);
                }
            }
        }
        return of.weighed(factors);
    }

    /** What is told of the outliers of a run; empty where it has no more than chance brings. */
    static Optional<String> notice(MeasuredRun run, List<Misses.Row> rows, Noise noise) {
        StringJoiner of = new StringJoiner(", ");
        for (Misses.Row row : rows) {
            double scale = noise.of(row.channel(), row.axis()) * SPREAD;
            if (hasOutliers(run, row, scale)) {
                of.add(
                        "%d of %s %s"
                                .formatted(
                                        beyond(FAR * scale, run, row),
                                        name(row.channel()),
                                        "xyz".charAt(row.axis())));
            }
        }
        return of.length() == 0
                ? Optional.empty()
                : Optional.of(
                        "of the %d samples of %s these are outliers and count less: %s"
                                .formatted(run.size(), run.name(), of));
    }

    /** For people. */
    static String name(Channel channel) {
        return channel.name().toLowerCase(Locale.ROOT).replace('_', ' ');
    }

    private static boolean hasOutliers(MeasuredRun run, Misses.Row row, double scale) {
        int far = beyond(FAR * scale, run, row);
        return far > Math.max(MOST_BY_CHANCE, MOST_FAR * run.size())
                || beyond(ASTRAY * scale, run, row) > 0;
    }

    private static int beyond(double limit, MeasuredRun run, Misses.Row row) {
        int count = 0;
        for (int k = 2; k + 2 < run.size(); k++) {
            count += Math.abs(off(run, row, k)) > limit ? 1 : 0;
        }
        return count;
    }

    private static double factor(double z) {
        return Double.isNaN(z) ? 1 : Math.sqrt((FREEDOM + 1) / (FREEDOM + z * z));
    }

    private static double off(MeasuredRun run, Misses.Row row, int k) {
        double sum = 0;
        for (int j = 0; j < CUBIC.length; j++) {
            int neighbour = k - 2 + j;
            sum +=
                    CUBIC[j]
                            * (row.channel() == Channel.ORIENTATION
                                    ? turn(run, row.axis(), k, neighbour)
                                    : run.value(row.channel(), neighbour, row.axis()));
        }
        return sum;
    }

    private static double turn(MeasuredRun run, int axis, int from, int to) {
        Optional<Quat> one = run.orientation(from);
        Optional<Quat> other = run.orientation(to);
        return one.isPresent() && other.isPresent()
                ? Misses.axis(Misses.turn(one.get(), other.get()), axis)
                : Double.NaN;
    }
}
