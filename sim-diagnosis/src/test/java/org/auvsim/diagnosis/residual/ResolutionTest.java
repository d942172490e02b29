package org.auvsim.diagnosis.residual;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import java.util.Random;
import java.util.stream.IntStream;

class ResolutionTest {
    /** Of an encoder with 4096 counts a turn, written with six decimals, what swings slowly. */
    @Test
    void anEncoderIsOffByWhatItDoesNotCount() {
        double step = 2 * Math.PI / 4096;
        double[] told =
                IntStream.range(0, 500)
                        .mapToDouble(k -> step * Math.rint(0.3 * Math.sin(0.02 * k) / step))
                        .map(angle -> Math.rint(1e6 * angle) / 1e6)
                        .toArray();

        assertThat(Resolution.deviation(changes(told)))
                .isCloseTo(step / Math.sqrt(12), within(1e-6));
    }

    @ParameterizedTest(name = "seed {0}")
    @ValueSource(longs = {1, 2, 3})
    void noiseIsNotCounted(long seed) {
        double[] told = new Random(seed).doubles(200).toArray();

        assertThat(Resolution.deviation(changes(told))).isZero();
    }

    @Test
    void aFewChangesTellNothing() {
        assertThat(Resolution.deviation(new double[] {0, 0, 1, 0, -1, 0, 2})).isZero();
    }

    private static double[] changes(double[] told) {
        return IntStream.range(1, told.length).mapToDouble(k -> told[k] - told[k - 1]).toArray();
    }
}
