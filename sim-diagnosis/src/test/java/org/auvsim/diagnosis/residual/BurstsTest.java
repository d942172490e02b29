package org.auvsim.diagnosis.residual;

import static org.assertj.core.api.Assertions.assertThat;

import org.auvsim.diagnosis.run.Channel;
import org.auvsim.diagnosis.run.MeasuredRun;
import org.auvsim.diagnosis.run.MeasuredRunBuilder;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import java.util.function.IntToDoubleFunction;

class BurstsTest {
    private static final int SAMPLES = 400;

    /**
     * The indices of the numbers in bursts, of a coordinate in standard deviations of its noise.
     */
    private static List<Integer> bursts(IntToDoubleFunction coordinate) {
        Random random = new Random(5);
        MeasuredRunBuilder run = MeasuredRun.named("dive");
        for (int k = 0; k < SAMPLES; k++) {
            run.at(0.1 * k)
                    .position(coordinate.applyAsDouble(k) + random.nextGaussian(), 0, Double.NaN);
        }
        double[] off = Bursts.off(Series.of(run.build(), Channel.POSITION, 0), 1, 1);
        List<Integer> found = new ArrayList<>();
        for (int i = 0; i < off.length; i++) {
            if (off[i] != 0) {
                found.add(i);
            }
        }
        return found;
    }

    private static double astray(int k, int first, int length, double by) {
        return k >= first && k < first + length ? by : 0;
    }

    /** On a way that is straight for the moment, by the noise, or bent. */
    @ParameterizedTest
    @CsvSource({"0, 12", "0.2, 20", "2, 20", "2, -40"})
    void numbersThatAreOffTogetherAreFound(double bend, double by) {
        assertThat(
                        bursts(
                                k ->
                                        bend * k * k
                                                + astray(k, 50, 2, by)
                                                + astray(k, 200, 3, -by)
                                                + astray(k, 3, 2, by)
                                                + astray(k, SAMPLES - 5, 3, by)))
                .containsExactly(
                        3, 4, 50, 51, 200, 201, 202, SAMPLES - 5, SAMPLES - 4, SAMPLES - 3);
    }

    /** Where nothing comes before or after, two are enough; one may be where a motion changes. */
    @ParameterizedTest
    @ValueSource(ints = {2, 3})
    void endsAreLookedAt(int length) {
        assertThat(bursts(k -> astray(k, 0, length, 12) + astray(k, SAMPLES - length, length, -12)))
                .hasSize(2 * length)
                .contains(0, SAMPLES - 1);
        assertThat(bursts(k -> astray(k, 0, 1, 12) + astray(k, SAMPLES - 1, 1, -12))).isEmpty();
        assertThat(bursts(k -> astray(k, 1, 1, 12) + astray(k, SAMPLES - 2, 1, -12)))
                .containsExactly(1, SAMPLES - 2);
    }

    @Test
    void noiseHasNone() {
        assertThat(bursts(_ -> 0)).isEmpty();
    }

    /** A run of a few numbers tells no burst, nor does an empty one. */
    @ParameterizedTest
    @ValueSource(ints = {0, 1, 2, 5, 7})
    void aShortRunHasNone(int size) {
        MeasuredRunBuilder run = MeasuredRun.named("dive");
        for (int k = 0; k < 7; k++) {
            run.at(0.1 * k).position(k < size ? k * k : Double.NaN, 0, 0);
        }
        Series series = Series.of(run.build(), Channel.POSITION, 0);

        assertThat(Bursts.off(series, 1e-3, 1)).isEqualTo(new double[size]);
    }

    /** A ball's height: what turns round at once is a kink, however sharp. */
    @ParameterizedTest
    @ValueSource(doubles = {1, 2, 3, 5, 7, 8, 9, 10, 15, 30, 100})
    void aBounceIsNone(double speed) {
        int[] bounces = {40, 100, 133, 180, 250, 299, 350};
        for (double within : new double[] {0, 0.25, 0.5, 0.75}) {
            assertThat(
                            bursts(
                                    k -> {
                                        double since = 1e3;
                                        for (int bounce : bounces) {
                                            since = Math.min(since, Math.abs(k - bounce - within));
                                        }
                                        return speed * since;
                                    }))
                    .as("%s", within)
                    .isEmpty();
        }
    }

    /** Rows that hardly follow a swing: two aside, two back. */
    @ParameterizedTest
    @ValueSource(doubles = {1, 2, 5, 20, 200})
    void aQuickSwingIsNone(double amplitude) {
        assertThat(bursts(k -> amplitude * Math.sin(1.5 * k))).isEmpty();
        assertThat(bursts(k -> amplitude * Math.sin(0.9 * k))).isEmpty();
    }

    /** What stays aside has been moved. */
    @Test
    void aLeapThatLastsIsNone() {
        assertThat(bursts(k -> astray(k, 100, 4, 20) + astray(k, 200, 100, 20))).isEmpty();
    }
}
