package org.auvsim.diagnosis.residual;

import org.apache.commons.math3.stat.descriptive.rank.Median;

/** The spread of most numbers, which outliers do not mislead (Hampel 1974). */
public final class MedianAbsoluteDeviation {
    /** Of a normal distribution: the median absolute deviation in standard deviations. */
    private static final double NORMAL = 0.6745;

    private MedianAbsoluteDeviation() {}

    /**
     * The standard deviation of normally distributed numbers whose sizes have the same median.
     *
     * @param sizes by how much each is off what is expected, none below 0, in any unit
     * @return in the same unit; NaN of no numbers
     */
    public static double standardDeviation(double[] sizes) {
        return new Median().evaluate(sizes) / NORMAL;
    }
}
