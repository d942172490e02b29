package org.auvsim.core.world;

/**
 * World time (s) as the compensated sum of the steps (Kahan, Comm. ACM 8, 1965): a thousand steps
 * of 0.05 s end at 50 s, not beside it.
 */
final class Clock {
    private double time;
    private double lost;

    Clock(double start) {
        time = start;
    }

    Clock(Clock original) {
        time = original.time;
        lost = original.lost;
    }

    double time() {
        return time;
    }

    void advance(double elapsed) {
        double rest = elapsed - lost;
        double sum = time + rest;
        lost = (sum - time) - rest;
        time = sum;
    }
}
