package org.auvsim.diagnosis.reading;

import org.apache.commons.math3.stat.StatUtils;

import java.util.ArrayList;
import java.util.List;

/** By how much numbers change from row to row where that is mostly noise. */
final class UsualChange {
    /** Fewer numbers tell nothing. */
    static final int FEWEST = 20;

    /** What differs from row to row by noise does so in this share of rows. */
    private static final double MOST = 0.98;

    /** Third differences are noise if they are as large as this share of the first ones. */
    private static final double NOISY = 0.2;

    private UsualChange() {}

    /** That of all numbers but those that stay; NaN if they do not change, or not by noise. */
    static double of(double[] values, boolean[] stays) {
        List<Double> first = new ArrayList<>();
        List<Double> third = new ArrayList<>();
        for (int i = 3; i < values.length; i++) {
            if (!stays[i] && !stays[i - 1] && !stays[i - 2] && !stays[i - 3]) {
                first.add(Math.abs(values[i] - values[i - 1]));
                third.add(
                        Math.abs(
                                values[i] - 3 * values[i - 1] + 3 * values[i - 2] - values[i - 3]));
            }
        }
        long changes = first.stream().filter(change -> change > 0).count();
        boolean areNoise =
                first.size() >= FEWEST
                        && changes >= MOST * first.size()
                        && median(third) > NOISY * median(first);
        return areNoise ? median(first) : Double.NaN;
    }

    private static double median(List<Double> of) {
        return StatUtils.percentile(of.stream().mapToDouble(Double::doubleValue).toArray(), 50);
    }
}
