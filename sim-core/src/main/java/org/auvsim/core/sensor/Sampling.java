package org.auvsim.core.sensor;

import org.auvsim.core.description.Default;
import org.auvsim.core.description.Unit;
import org.auvsim.core.entity.Domain;

/**
 * When a sensor measures, and what becomes of its readings on their way.
 *
 * @param rate readings a second; reading k is taken at world time k / rate
 * @param delay from the measurement until the reading is there
 * @param dropout share of the readings that never arrive, 0 to 1; each is lost or not on its own
 * @param seed of its noise; sensors of other names or objects have other noise at the same seed
 */
public record Sampling(
        @Unit("Hz") double rate,
        @Unit("s") @Default("0.0") double delay,
        @Default("0.0") double dropout,
        @Default("0") long seed) {
    private static final double FASTEST = 100_000;

    /** Times that differ by less are one instant (s; from 1 s on, a share). */
    private static final double SAME = 1e-9;

    /**
     * A checked sampling.
     *
     * @throws IllegalArgumentException if the rate is not positive or above 100,000 Hz, the delay
     *     negative or not finite, or the dropout outside [0, 1]
     */
    public Sampling {
        boolean isInRange = rate > 0 && rate <= FASTEST;
        Domain.require(isInRange, "a sensor", "rate", rate, "above 0 and at most 100000 Hz", "Hz");
        Domain.atLeast0("a sensor", "delay", delay, "s");
        Domain.within("a sensor", "dropout", 0, 1, dropout, "");
    }

    /** Readings at a rate (Hz) that arrive at once, and all of them. */
    public static Sampling at(double rate) {
        return new Sampling(rate, 0, 0, 0);
    }

    /** World time (s) of reading {@code k}. */
    public double time(long k) {
        return k / rate;
    }

    /** The first reading after a time (s); one at that time itself, but for rounding, is before. */
    public long firstAfter(double time) {
        long k = (long) Math.floor(time * rate);
        while (isBy(time(k), time)) {
            k++;
        }
        while (!isBy(time(k - 1), time)) {
            k--;
        }
        return k;
    }

    /** Whether an instant (s) is no later than a time (s), but for rounding. */
    public static boolean isBy(double instant, double time) {
        return instant <= time + SAME * Math.max(1, Math.abs(time));
    }
}
