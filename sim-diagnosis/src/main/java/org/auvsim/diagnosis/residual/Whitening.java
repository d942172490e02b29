package org.auvsim.diagnosis.residual;

import org.auvsim.auvsml.run.LastingError;
import org.auvsim.diagnosis.run.MeasuredRun;

import java.util.List;
import java.util.Optional;

/**
 * Takes from what a row of misses is what those before tell of it, where errors last: by the Kalman
 * filter of a sum of Ornstein-Uhlenbeck processes in white noise. What is left is as likely as the
 * whole series, and independent (Kailath 1968).
 */
final class Whitening {
    private final List<LastingError> errors;

    Whitening(List<LastingError> errors) {
        this.errors = errors;
    }

    /** By errors that last, if there are any. */
    static Optional<Whitening> of(List<LastingError> errors) {
        return errors.isEmpty() ? Optional.empty() : Optional.of(new Whitening(errors));
    }

    /** What is known of each error, by what was measured so far. */
    private static final class Belief {
        private final List<LastingError> errors;
        private final double[] expected;
        private final double[][] covariance;

        Belief(List<LastingError> errors, double since) {
            this.errors = errors;
            expected = new double[errors.size()];
            covariance = new double[errors.size()][errors.size()];
            for (int e = 0; e < expected.length; e++) {
                covariance[e][e] = variance(errors.get(e), since);
            }
        }

        /** After a time (s) in which nothing was measured. */
        void age(double time) {
            for (int a = 0; a < expected.length; a++) {
                double kept = kept(errors.get(a), time);
                expected[a] *= kept;
                for (int b = 0; b < expected.length; b++) {
                    covariance[a][b] *= kept;
                    covariance[b][a] *= kept;
                }
                double deviation = errors.get(a).deviation();
                covariance[a][a] += deviation * deviation * (1 - kept * kept);
            }
        }

        private static double kept(LastingError error, double time) {
            return StrictMath.exp(-time / error.time());
        }

        /**
         * Measures their sum.
         *
         * @param miss in standard deviations of the noise
         * @param weight one over the noise's deviation
         * @return what was not to be expected, in standard deviations
         */
        double innovation(double miss, double weight) {
            double sum = 0;
            double variance = 0;
            double[] withSum = new double[expected.length];
            for (int a = 0; a < expected.length; a++) {
                sum += expected[a];
                for (int b = 0; b < expected.length; b++) {
                    withSum[a] += covariance[a][b];
                }
                variance += withSum[a];
            }
            double innovation = miss - weight * sum;
            double spread = 1 + weight * weight * variance;
            for (int a = 0; a < expected.length; a++) {
                double gain = weight * withSum[a] / spread;
                expected[a] += gain * innovation;
                for (int b = 0; b < expected.length; b++) {
                    covariance[a][b] -= gain * weight * withSum[b];
                }
            }
            return innovation / Math.sqrt(spread);
        }
    }

    /** Variance of an error so long (s) after the run's beginning. */
    private static double variance(LastingError error, double since) {
        double square = error.deviation() * error.deviation();
        return error.grows() ? square * (1 - StrictMath.exp(-2 * since / error.time())) : square;
    }

    /**
     * Whitens one row of misses.
     *
     * @param misses in standard deviations of the noise; afterwards in those of all that is unknown
     * @param weights one over the noise's deviation, 0 where nothing was measured
     * @param from the sample that the misses begin with
     */
    void apply(double[] misses, double[] weights, MeasuredRun run, int from, int row, int rows) {
        Belief belief = new Belief(errors, run.time(from) - run.time(0));
        int samples = misses.length / rows;
        for (int k = 0; k < samples; k++) {
            if (k > 0) {
                belief.age(run.time(from + k) - run.time(from + k - 1));
            }
            double weight = weights[(from + k) * rows + row];
            if (weight > 0) {
                misses[k * rows + row] = belief.innovation(misses[k * rows + row], weight);
            }
        }
    }

    /**
     * How many independent numbers tell as much of a level as a row does: the sum of all elements
     * of the inverse of its correlation matrix (Jones 2011, Statistics in Medicine 30:3050).
     *
     * @param weights as in {@link #apply}
     */
    double independent(double[] weights, MeasuredRun run, int row, int rows) {
        double[] deviations = new double[run.size() * rows];
        for (int k = 0; k < run.size(); k++) {
            double weight = weights[k * rows + row];
            if (weight > 0) {
                double since = run.time(k) - run.time(0);
                double lasting = errors.stream().mapToDouble(e -> variance(e, since)).sum();
                deviations[k * rows + row] = Math.sqrt(1 + weight * weight * lasting);
            }
        }
        apply(deviations, weights, run, 0, row, rows);
        return Outcome.squares(deviations);
    }
}
