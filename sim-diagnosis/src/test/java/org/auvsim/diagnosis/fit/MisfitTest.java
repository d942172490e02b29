package org.auvsim.diagnosis.fit;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;

import java.util.stream.IntStream;

class MisfitTest {
    private static final double INTERVAL = 0.5;

    private static double[] swing(int samples, double frequency) {
        return IntStream.range(0, samples)
                .mapToDouble(k -> Math.sin(2 * Math.PI * frequency * INTERVAL * k))
                .toArray();
    }

    /** Four turns within 16 samples, of which the last is followed by no interval. */
    @Test
    void aFrequencyIsThatOfTheSwing() {
        double frequency = 4 / (16 * INTERVAL);

        assertThat(Misfit.frequency(swing(16, frequency), 15 * INTERVAL).orElseThrow())
                .isCloseTo(frequency, within(1e-12));
        assertThat(Misfit.frequency(swing(20, frequency), 19 * INTERVAL).orElseThrow())
                .isCloseTo(frequency, within(1e-12));
    }

    @Test
    void whatDoesNotSwingHasNone() {
        assertThat(Misfit.frequency(new double[16], 15 * INTERVAL)).isEmpty();
    }
}
