package org.auvsim.diagnosis.verdict;

import java.util.List;

/**
 * Whether runs that had no part in a search bear out what it found. What a true cause changes of
 * their prediction, squared, is what it gains there, give or take twice the root of that (a normal
 * number of that variance); what only fitted the other runs' noise loses as much instead.
 */
final class Confirmation {
    /** At least this share of the change must be gain, but for chance. */
    private static final double SHARE = 0.5;

    /** So many roots of the change are left to chance. */
    private static final double CHANCE = 1.5;

    /** What changes the runs no more than this, squared, is not theirs to judge. */
    private static final double NOTHING = 0.1;

    private Confirmation() {}

    /**
     * Whether it is borne out.
     *
     * @param before by run, what the believed model misses, in standard deviations of the noise
     * @param after what is missed with the causes, which were adjusted to these runs
     * @param parameters how many numbers were adjusted: each may gain as much as noise, but no more
     *     than it changes
     */
    static boolean of(List<double[]> before, List<double[]> after, int parameters) {
        double change = 0;
        double gain = 0;
        double left = 0;
        int count = 0;
        for (int r = 0; r < after.size(); r++) {
            double[] one = before.get(r);
            double[] other = after.get(r);
            for (int i = 0; i < other.length; i++) {
                change += (one[i] - other[i]) * (one[i] - other[i]);
                gain += one[i] * one[i] - other[i] * other[i];
                left += other[i] * other[i];
            }
            count += other.length;
        }
        if (Double.isNaN(left)) {
            return false;
        }
        gain -= Math.min(parameters, change);
        double noise = Math.max(1, left / count);
        return Double.isNaN(change)
                || change / noise < NOTHING
                || gain / noise >= SHARE * change / noise - CHANCE * Math.sqrt(change / noise);
    }
}
