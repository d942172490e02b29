package org.auvsim.diagnosis.reading;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class OrdinalTest {
    @ParameterizedTest
    @CsvSource({
        "2, second", "3, third", "4, 4th", "10, 10th", "11, 11th", "12, 12th", "13, 13th",
        "21, 21st", "22, 22nd", "23, 23rd", "24, 24th", "101, 101st", "111, 111th", "112, 112th",
    })
    void asPeopleSayIt(int number, String words) {
        assertThat(Ordinal.of(number)).isEqualTo(words);
    }
}
