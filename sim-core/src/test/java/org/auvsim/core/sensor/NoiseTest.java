package org.auvsim.core.sensor;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import java.util.SplittableRandom;
import java.util.stream.DoubleStream;
import java.util.stream.LongStream;

class NoiseTest {
    private static final int MANY = 40_000;

    private static Noise noise(long seed, long k) {
        return Noise.of(7, "depth", new Sampling(4, 0, 0, seed), k);
    }

    private static double[] gaussians(long seed, int channel) {
        return LongStream.rangeClosed(1, MANY)
                .mapToDouble(k -> noise(seed, k).gaussian(channel))
                .toArray();
    }

    private static double mean(double[] x) {
        return DoubleStream.of(x).average().orElseThrow();
    }

    private static double covariance(double[] x, double[] y) {
        double sum = 0;
        for (int i = 0; i < x.length; i++) {
            sum += x[i] * y[i];
        }
        return sum / x.length;
    }

    /** Of n numbers, the mean errs by 1/sqrt(n), the variance by sqrt(2/n): five of these. */
    @ParameterizedTest(name = "seed {0}")
    @ValueSource(longs = {0, 1, -5, 123456789})
    void gaussiansHaveMean0Variance1AndTheTailsOfTheNormalDistribution(long seed) {
        double[] x = gaussians(seed, 0);

        assertThat(mean(x)).isCloseTo(0, within(5 / Math.sqrt(MANY)));
        assertThat(covariance(x, x)).isCloseTo(1, within(5 * Math.sqrt(2.0 / MANY)));
        double beyond2 = DoubleStream.of(x).filter(v -> Math.abs(v) > 2).count() / (double) MANY;
        assertThat(beyond2).isCloseTo(0.0455, within(5 * Math.sqrt(0.0455 / MANY)));
    }

    @Test
    void neighboursChannelsSeedsObjectsAndSensorsAreIndependent() {
        double[] x = gaussians(1, 0);
        double[] shifted = new double[MANY];
        System.arraycopy(x, 1, shifted, 0, MANY - 1);
        double[] other =
                LongStream.rangeClosed(1, MANY)
                        .mapToDouble(
                                k -> Noise.of(8, "depth", new Sampling(4, 0, 0, 1), k).gaussian(0))
                        .toArray();
        double[] namesake =
                LongStream.rangeClosed(1, MANY)
                        .mapToDouble(
                                k -> Noise.of(7, "Depth", new Sampling(4, 0, 0, 1), k).gaussian(0))
                        .toArray();

        double bound = 5 / Math.sqrt(MANY);
        assertThat(covariance(x, shifted)).isCloseTo(0, within(bound));
        assertThat(covariance(x, gaussians(1, 1))).isCloseTo(0, within(bound));
        assertThat(covariance(x, gaussians(2, 0))).isCloseTo(0, within(bound));
        assertThat(covariance(x, other)).isCloseTo(0, within(bound));
        assertThat(covariance(x, namesake)).isCloseTo(0, within(bound));
    }

    @Test
    void uniformNumbersFillTheUnitInterval() {
        double[] u =
                LongStream.rangeClosed(1, MANY).mapToDouble(k -> noise(3, k).uniform(0)).toArray();

        assertThat(mean(u)).isCloseTo(0.5, within(5 * Math.sqrt(1.0 / 12 / MANY)));
        assertThat(DoubleStream.of(u)).allMatch(v -> v >= 0 && v < 1);
    }

    @Test
    void stepsOfTheWalkAreIndependentAndOfEqualVariance() {
        double[] steps = new double[MANY];
        for (int k = 1; k <= MANY; k++) {
            steps[k - 1] = noise(5, k).walk(0) - noise(5, k - 1).walk(0);
        }
        double[] shifted = new double[MANY];
        System.arraycopy(steps, 1, shifted, 0, MANY - 1);

        // at 4 Hz a step has 1/4 s
        assertThat(covariance(steps, steps)).isCloseTo(0.25, within(1.25 * Math.sqrt(2.0 / MANY)));
        assertThat(covariance(steps, shifted)).isCloseTo(0, within(1.25 / Math.sqrt(MANY)));
    }

    @ParameterizedTest(name = "sample {0}")
    @ValueSource(longs = {1, 2, 3, 7, 64, 1000, 86_400, -90})
    void theVarianceOfTheWalkIsTheTime(long k) {
        double[] ends =
                LongStream.rangeClosed(1, 10_000)
                        .mapToDouble(seed -> noise(seed, k).walk(0))
                        .toArray();

        double time = Math.abs(k) / 4.0;
        assertThat(mean(ends)).isCloseTo(0, within(5 * Math.sqrt(time / ends.length)));
        assertThat(covariance(ends, ends))
                .isCloseTo(time, within(5 * time * Math.sqrt(2.0 / ends.length)));
        assertThat(noise(1, 0).walk(0)).isZero();
    }

    @ParameterizedTest(name = "seed {0}")
    @ValueSource(longs = {1, 2, 3})
    void whatIsRememberedOfTheWalkChangesNothing(long seed) {
        Noise remembering = noise(seed, 0);
        SplittableRandom random = new SplittableRandom(seed);
        for (int i = 0; i < 3000; i++) {
            long k = i < 1000 ? i : random.nextLong(-5000, 5000);
            int channel = random.nextInt(3);

            assertThat(remembering.at(k).walk(channel))
                    .as("sample %s of channel %s", k, channel)
                    .isEqualTo(noise(seed, k).walk(channel));
            assertThat(remembering.at(k).gaussian(channel))
                    .isEqualTo(noise(seed, k).gaussian(channel));
        }
    }
}
