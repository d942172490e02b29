package org.auvsim.diagnosis.residual;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.apache.commons.math3.linear.Array2DRowRealMatrix;
import org.apache.commons.math3.linear.ArrayRealVector;
import org.apache.commons.math3.linear.CholeskyDecomposition;
import org.apache.commons.math3.linear.MatrixUtils;
import org.apache.commons.math3.linear.RealMatrix;
import org.apache.commons.math3.linear.RealVector;
import org.auvsim.auvsml.run.LastingError;
import org.auvsim.diagnosis.run.MeasuredRun;
import org.auvsim.diagnosis.run.MeasuredRunBuilder;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import java.util.Arrays;
import java.util.List;
import java.util.Random;

/** The filter against the covariance of all samples at once, by its Cholesky decomposition. */
class WhiteningTest {
    private static final int SAMPLES = 30;
    private static final int FROM = 4;
    private static final double NOISE = 0.02;
    private static final LastingError ERROR = new LastingError(0.05, 0.6);
    private static final LastingError GROWING = new LastingError(0.05, 0.6, true);

    @ParameterizedTest(name = "seed {0}")
    @ValueSource(longs = {1, 2, 3})
    void whatIsLeftIsWhatTheCovarianceLeaves(long seed) {
        isWhatTheCovarianceLeaves(seed, List.of(ERROR));
    }

    @ParameterizedTest(name = "seed {0}")
    @ValueSource(longs = {1, 2, 3})
    void anErrorThatGrowsIsNoneWhereTheRunBegins(long seed) {
        isWhatTheCovarianceLeaves(seed, List.of(GROWING));
    }

    @ParameterizedTest(name = "seed {0}")
    @ValueSource(longs = {1, 2, 3})
    void errorsOfSeveralKindsAddUp(long seed) {
        isWhatTheCovarianceLeaves(
                seed, List.of(GROWING, new LastingError(0.03, 1e6), new LastingError(0.1, 0.2)));
    }

    private static void isWhatTheCovarianceLeaves(long seed, List<LastingError> errors) {
        Random random = new Random(seed);
        MeasuredRun run = uneven(random, FROM + SAMPLES);
        double[] off = random.doubles(SAMPLES, -0.2, 0.2).toArray();
        double[] weights = new double[2 * (FROM + SAMPLES)];
        double[] misses = new double[2 * SAMPLES];
        for (int k = 0; k < SAMPLES; k++) {
            weights[2 * (FROM + k) + 1] = 1 / NOISE;
            misses[2 * k] = k;
            misses[2 * k + 1] = off[k] / NOISE;
        }

        new Whitening(errors).apply(misses, weights, run, FROM, 1, 2);

        RealVector expected = new ArrayRealVector(off);
        RealMatrix root = new CholeskyDecomposition(covariance(run, FROM, errors)).getL();
        MatrixUtils.solveLowerTriangularSystem(root, expected);
        for (int k = 0; k < SAMPLES; k++) {
            assertThat(misses[2 * k + 1]).isCloseTo(expected.getEntry(k), within(1e-9));
            assertThat(misses[2 * k]).isEqualTo(k);
        }
    }

    private static MeasuredRun uneven(Random random, int samples) {
        MeasuredRunBuilder builder = MeasuredRun.named("run");
        double time = 0;
        for (int k = 0; k < samples; k++) {
            time += 0.02 + 0.2 * random.nextDouble();
            builder.at(time);
        }
        return builder.build();
    }

    private static RealMatrix covariance(MeasuredRun run, int from, List<LastingError> errors) {
        int size = run.size() - from;
        RealMatrix covariance = new Array2DRowRealMatrix(size, size);
        for (int i = 0; i < size; i++) {
            for (int j = 0; j < size; j++) {
                double sum = i == j ? NOISE * NOISE : 0;
                for (LastingError error : errors) {
                    double apart = Math.abs(run.time(from + i) - run.time(from + j));
                    double since = run.time(from + i) + run.time(from + j) - 2 * run.time(0);
                    double old = error.grows() ? Math.exp(-since / error.time()) : 0;
                    sum += Math.pow(error.deviation(), 2) * (Math.exp(-apart / error.time()) - old);
                }
                covariance.setEntry(i, j, sum);
            }
        }
        return covariance;
    }

    /** The sum of the elements of the inverse of the correlation matrix, by inverting it. */
    @ParameterizedTest(name = "seed {0}")
    @ValueSource(longs = {1, 2, 3})
    void numbersWhoseErrorsLastTellLess(long seed) {
        MeasuredRun run = uneven(new Random(seed), SAMPLES);
        double[] weights = new double[SAMPLES];
        Arrays.fill(weights, 1 / NOISE);
        List<LastingError> errors = List.of(GROWING, new LastingError(0.03, 2));

        double independent = new Whitening(errors).independent(weights, run, 0, 1);

        RealMatrix correlation = covariance(run, 0, errors);
        double[] root = new double[SAMPLES];
        Arrays.setAll(root, i -> Math.sqrt(correlation.getEntry(i, i)));
        for (int i = 0; i < SAMPLES; i++) {
            for (int j = 0; j < SAMPLES; j++) {
                correlation.multiplyEntry(i, j, 1 / (root[i] * root[j]));
            }
        }
        RealVector ones = new ArrayRealVector(SAMPLES, 1);
        RealVector solved = new CholeskyDecomposition(correlation).getSolver().solve(ones);
        assertThat(independent)
                .isCloseTo(ones.dotProduct(solved), within(1e-9))
                .isBetween(1.0, (double) SAMPLES);
        assertThat(
                        new Whitening(List.of(new LastingError(1e-9, 1)))
                                .independent(weights, run, 0, 1))
                .isCloseTo(SAMPLES, within(1e-6));
    }

    @ParameterizedTest(name = "from sample {0}")
    @ValueSource(ints = {0, 7, 8})
    void whatIsNotMeasuredIsPassedOver(int missing) {
        MeasuredRunBuilder all = MeasuredRun.named("all");
        MeasuredRunBuilder others = MeasuredRun.named("others");
        double[] misses = new double[SAMPLES];
        double[] fewer = new double[SAMPLES - 1];
        double[] weights = new double[SAMPLES];
        double[] ones = new double[SAMPLES - 1];
        int j = 0;
        for (int k = 0; k < SAMPLES; k++) {
            all.at(0.1 * k);
            if (k != missing) {
                others.at(0.1 * k);
                misses[k] = k % 3;
                weights[k] = 1;
                fewer[j] = k % 3;
                ones[j++] = 1;
            }
        }

        new Whitening(List.of(ERROR)).apply(misses, weights, all.build(), 0, 0, 1);
        new Whitening(List.of(ERROR)).apply(fewer, ones, others.build(), 0, 0, 1);

        assertThat(misses[missing]).isZero();
        assertThat(misses[SAMPLES - 1]).isCloseTo(fewer[SAMPLES - 2], within(1e-12));
    }
}
