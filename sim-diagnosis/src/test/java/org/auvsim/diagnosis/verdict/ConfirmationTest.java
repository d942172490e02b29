package org.auvsim.diagnosis.verdict;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import java.util.Arrays;
import java.util.List;
import java.util.Random;

/** Noise of one standard deviation, and an effect that is there, or only believed to be. */
class ConfirmationTest {
    private static final int COUNT = 2000;
    private static final int CASES = 200;

    private static double[] noise(Random random) {
        double[] noise = new double[COUNT];
        Arrays.setAll(noise, i -> random.nextGaussian());
        return noise;
    }

    /** The misses with an effect that changes each number by so much. */
    private static double[] shifted(double[] misses, double by) {
        return Arrays.stream(misses).map(miss -> miss + by).toArray();
    }

    /** How many of many effects are borne out, each of one parameter. */
    private static long confirmed(double change, boolean isThere) {
        double by = Math.sqrt(change / COUNT);
        Random random = new Random(7);
        long confirmed = 0;
        for (int c = 0; c < CASES; c++) {
            double[] noise = noise(random);
            double[] before = isThere ? shifted(noise, by) : noise;
            double[] after = shifted(before, -by);
            confirmed += Confirmation.of(List.of(before), List.of(after), 1) ? 1 : 0;
        }
        return confirmed;
    }

    @ParameterizedTest
    @ValueSource(doubles = {25, 100, 1000})
    void whatIsThereIsBorneOut(double change) {
        assertThat(confirmed(change, true)).isGreaterThan(CASES * 96 / 100);
    }

    @ParameterizedTest
    @ValueSource(doubles = {25, 100, 1000})
    void whatIsNotThereIsNot(double change) {
        assertThat(confirmed(change, false)).isLessThan(CASES * 4 / 100);
    }

    /** Such runs do not tell. */
    @ParameterizedTest
    @ValueSource(doubles = {1e-4, 0.01, 0.09})
    void whatHardlyChangesAnythingIsNotDenied(double change) {
        assertThat(confirmed(change, true)).isEqualTo(CASES);
    }

    @Test
    void whatChangesNothingIsNotDenied() {
        double[] misses = noise(new Random(1));

        assertThat(Confirmation.of(List.of(misses), List.of(misses), 4)).isTrue();
    }

    @Test
    void aMotionThatGetsLostBearsNothingOut() {
        double[] lost = {Double.NaN};

        assertThat(Confirmation.of(List.of(new double[1]), List.of(lost), 1)).isFalse();
        assertThat(Confirmation.of(List.of(lost), List.of(new double[1]), 1)).isTrue();
    }
}
