package org.auvsim.server.simulator;

import java.util.OptionalDouble;
import java.util.function.LongSupplier;

/**
 * When, on the wall's clock, a world that aims at a rate makes its steps. It catches up after a
 * short delay; what it cannot catch up with it skips, and counts.
 */
final class Pace {
    /** So far (s) it may fall behind before it skips. */
    static final double CATCHES_UP = 0.5;

    private final LongSupplier nanoClock;
    private OptionalDouble rate;
    private long startNanos;
    private long lastNanos;
    private double startTime;

    /**
     * A pace.
     *
     * @param rate world seconds a second; empty: as fast as possible
     * @param nanoClock the wall's clock (ns), as {@link System#nanoTime}
     */
    Pace(OptionalDouble rate, LongSupplier nanoClock) {
        this.rate = requirePositive(rate);
        this.nanoClock = nanoClock;
        this.lastNanos = nanoClock.getAsLong();
    }

    private static OptionalDouble requirePositive(OptionalDouble rate) {
        if (rate.isPresent() && !(rate.getAsDouble() > 0 && rate.getAsDouble() < 1e9)) {
            throw new IllegalArgumentException(
                    "the rate must be above 0 world seconds a second, but is "
                            + rate.getAsDouble());
        }
        return rate;
    }

    /** World seconds a second; empty: as fast as possible. */
    OptionalDouble rate() {
        return rate;
    }

    /** Goes on from a world time (s), now, at another rate. */
    void set(OptionalDouble rate, double worldTime) {
        this.rate = requirePositive(rate);
        start(worldTime);
    }

    /** Goes on from a world time (s), now. */
    void start(double worldTime) {
        startNanos = now();
        startTime = worldTime;
    }

    /** The wall's clock (ns). When it goes back, no time has passed. */
    long now() {
        long now = nanoClock.getAsLong();
        if (now - lastNanos < 0) {
            startNanos += now - lastNanos;
        }
        lastNanos = now;
        return now;
    }

    /** How long (ns) until the step that begins at a world time (s) is due; 0 or less: it is. */
    long nanosUntil(double worldTime) {
        if (rate.isEmpty()) {
            return 0;
        }
        double due = (worldTime - startTime) / rate.getAsDouble();
        long now = now(); // first: it may move the start
        return (long) (due * 1e9) - (now - startNanos);
    }

    /**
     * Goes on from a world time (s), now, if it is too far behind to be caught up with.
     *
     * @return the world time (s) that is skipped; 0 if all is well
     */
    double skipWhatIsLost(double worldTime) {
        double behind = -nanosUntil(worldTime) * 1e-9;
        if (rate.isEmpty() || behind <= CATCHES_UP) {
            return 0;
        }
        start(worldTime);
        return behind * rate.getAsDouble();
    }
}
