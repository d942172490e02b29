package org.auvsim.diagnosis.reading;

import static org.assertj.core.api.Assertions.assertThatThrownBy;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class StretchTest {
    @ParameterizedTest
    @CsvSource({
        "-3, Infinity, from -3 s after its first row to its end",
        "3, 2, from 3 s until 2 s after its first row",
        "NaN, 2, from NaN s until 2 s after its first row"
    })
    void timesThatAreNoStretchAreTold(double from, double until, String told) {
        assertThatThrownBy(() -> new Stretch(from, until))
                .hasMessage(
                        "a run is taken %s; expected 0 or more, and a later end".formatted(told));
    }
}
