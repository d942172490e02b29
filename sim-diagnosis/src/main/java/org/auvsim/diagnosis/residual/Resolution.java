package org.auvsim.diagnosis.residual;

/**
 * The step in which a sensor counts, as an encoder does. While little moves, such numbers have no
 * noise from one to the next, and yet are off by up to half a step.
 */
final class Resolution {
    /** Fewer changes tell nothing. */
    private static final int FEWEST = 8;

    /** Share of a step by which changes are off whole numbers of it: files are rounded, too. */
    private static final double ROUNDING = 0.02;

    private Resolution() {}

    /**
     * The standard deviation of what counting leaves out; 0 if the sensor does not count.
     *
     * @param changes of what it tells from one sample to the next, of either sign
     */
    static double deviation(double[] changes) {
        double step = Double.POSITIVE_INFINITY;
        int count = 0;
        for (double change : changes) {
            if (change != 0) {
                step = Math.min(step, Math.abs(change));
                count++;
            }
        }
        for (double change : changes) {
            double steps = Math.abs(change) / step;
            if (Math.abs(steps - Math.rint(steps)) > ROUNDING) {
                return 0;
            }
        }
        return count < FEWEST ? 0 : step / Math.sqrt(12);
    }
}
