package org.auvsim.experiments.scoreboard;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class ShareTest {
    /** Bounds as tabulated for the score interval without continuity correction. */
    @ParameterizedTest
    @CsvSource({"0, 200, 0, 0.01885", "9, 10, 0.59585, 0.98212", "81, 263, 0.2553, 0.3662"})
    void theIntervalIsThatOfWilson(int hits, int of, double low, double high) {
        Share share = new Share(hits, of);

        assertThat(share.low()).isCloseTo(low, within(1e-4));
        assertThat(share.high()).isCloseTo(high, within(1e-4));
    }

    @Test
    void nothingOfNothingIsADash() {
        assertThat(new Share(0, 0)).hasToString("-");
        assertThat(new Share(19, 20)).hasToString("95.0 % (19 of 20, 76-99)");
    }
}
