package org.auvsim.viz.source;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.auvsim.auvsml.message.control.SimulatorStateResponse;
import org.junit.jupiter.api.Test;

class PaceTest {
    private final Pace pace = new Pace();

    @Test
    void tellsWorldTimeForTimeOfTheClock() {
        for (int i = 0; i <= 20; i++) {
            hear(0.5 * i, 0.4 * i, "1.0");
        }
        assertThat(pace.reached()).hasValueCloseTo(0.8, within(1e-9));
    }

    @Test
    void onlyTheLastSecondsCount() {
        hear(0, 0, "max");
        hear(1, 100, "max");
        for (int i = 0; i <= 10; i++) {
            hear(50 + 0.5 * i, 100 + i, "max");
        }
        assertThat(pace.reached()).hasValueCloseTo(2.0, within(1e-9));
    }

    @Test
    void beginsAnewWhenAnotherRateIsWishedOrTimeGoesBack() {
        hear(0, 0, "1.0");
        hear(1, 1, "1.0");
        hear(1.5, 1.5, "4.0");
        assertThat(pace.reached()).isEmpty();
        hear(2.5, 5.5, "4.0");
        assertThat(pace.reached()).hasValueCloseTo(4.0, within(1e-9));
        hear(3, 0, "4.0");
        assertThat(pace.reached()).isEmpty();
    }

    @Test
    void tellsNothingOfWhatStandsStill() {
        hear(0, 0, "1.0");
        hear(1, 1, "1.0");
        pace.hear(new SimulatorStateResponse(1, false, "1.0", 10, 1), 1_200_000_000L);
        assertThat(pace.reached()).isEmpty();
    }

    private void hear(double clock, double time, String rate) {
        pace.hear(new SimulatorStateResponse(time, true, rate, 10, 1), Math.round(clock * 1e9));
    }
}
