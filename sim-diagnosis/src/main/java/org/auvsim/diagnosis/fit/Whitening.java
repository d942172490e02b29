package org.auvsim.diagnosis.fit;

import org.auvsim.auvsml.run.LastingError;
import org.auvsim.diagnosis.run.MeasuredRun;

/**
 * Takes from what a row of misses is what those before tell of it, where errors last: by the Kalman
 * filter of an Ornstein-Uhlenbeck process in white noise. What is left is as likely as the whole
 * series, and independent (Kailath 1968).
 */
final class Whitening {
    private final LastingError error;

    Whitening(LastingError error) {
        this.error = error;
    }

    /**
     * Whitens one row of misses.
     *
     * @param misses in standard deviations of the noise; afterwards in those of all that is unknown
     * @param weights one over the noise's deviation, 0 where nothing was measured
     * @param from the sample that the misses begin with
     */
    void apply(double[] misses, double[] weights, MeasuredRun run, int from, int row, int rows) {
        double square = error.deviation() * error.deviation();
        double expected = 0;
        double variance = square;
        if (error.grows()) {
            double since = run.time(from) - run.time(0);
            variance *= 1 - StrictMath.exp(-2 * since / error.time());
        }
        int samples = misses.length / rows;
        for (int k = 0; k < samples; k++) {
            if (k > 0) {
                double time = run.time(from + k) - run.time(from + k - 1);
                double kept = StrictMath.exp(-time / error.time());
                expected *= kept;
                variance = square + kept * kept * (variance - square);
            }
            double weight = weights[(from + k) * rows + row];
            if (weight == 0) {
                continue;
            }
            int i = k * rows + row;
            double innovation = misses[i] - weight * expected;
            double spread = 1 + weight * weight * variance;
            misses[i] = innovation / Math.sqrt(spread);
            double gain = weight * variance / spread;
            expected += gain * innovation;
            variance -= gain * weight * variance;
        }
    }
}
