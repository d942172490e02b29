package org.auvsim.core.sensor;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class SamplingTest {
    @ParameterizedTest
    @CsvSource({
        "10, 0, 1",
        "10, 0.25, 3",
        "10, 0.3, 4",
        "10, 0.30000000000000004, 4",
        "10, 0.29999999999999993, 4",
        "10, 0.2999, 3",
        "3, 1000000, 3000001",
        "10, -0.25, -2",
        "10, -1, -9",
    })
    void theFirstSampleAfterATimeIsNotAtThatTime(double rate, double time, long expected) {
        assertThat(Sampling.at(rate).firstAfter(time)).isEqualTo(expected);
    }

    @Test
    void whatMakesNoSenseIsRefused() {
        assertThatThrownBy(() -> Sampling.at(0))
                .hasMessage(
                        "the rate of a sensor must be above 0 and at most 100000 Hz, but is 0.0"
                                + " Hz");
        assertThatThrownBy(() -> Sampling.at(1e6)).hasMessageContaining("1000000.0");
        assertThatThrownBy(() -> new Sampling(1, -1, 0, 0))
                .hasMessage("the delay of a sensor must be 0 s or more and finite, but is -1.0 s");
        assertThatThrownBy(() -> new Sampling(1, 0, 1.5, 0))
                .hasMessage("the dropout of a sensor must be 0.0 to 1.0, but is 1.5");
    }
}
