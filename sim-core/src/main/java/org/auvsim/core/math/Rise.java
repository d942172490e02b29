package org.auvsim.core.math;

/**
 * A rise from 0 to 1 about an instant, and its slope: a raised cosine (Hann's window), so smooth
 * that integrators with steps of up to half its duration take it as a whole.
 */
public final class Rise {
    private Rise() {}

    /**
     * How much of the rise is over, 0 to 1.
     *
     * @param time (s)
     * @param middle of the rise (s)
     * @param duration of the rise (s); 0: a jump at its middle
     */
    public static double share(double time, double middle, double duration) {
        if (duration == 0) {
            return time < middle ? 0 : 1;
        }
        double x = (time - middle) / duration + 0.5;
        if (x <= 0 || x >= 1) {
            return x <= 0 ? 0 : 1;
        }
        return x - StrictMath.sin(2 * Math.PI * x) / (2 * Math.PI);
    }

    /**
     * How fast it rises (1/s).
     *
     * @param duration of the rise (s), above 0
     */
    public static double slope(double time, double middle, double duration) {
        double x = (time - middle) / duration + 0.5;
        return x <= 0 || x >= 1 ? 0 : (1 - StrictMath.cos(2 * Math.PI * x)) / duration;
    }
}
