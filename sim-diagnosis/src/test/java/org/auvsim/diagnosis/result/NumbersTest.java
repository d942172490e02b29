package org.auvsim.diagnosis.result;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class NumbersTest {
    @ParameterizedTest
    @CsvSource({
        "12.4321, 0.31, 12.4 +- 0.3",
        "12.4321, 0.12, 12.43 +- 0.12",
        "12.4321, 0.0962, 12.43 +- 0.10",
        "12.4321, 0.197, 12.4 +- 0.2",
        "1.2, 0.0098, 1.200 +- 0.010",
        "-0.5, 0.02, -0.50 +- 0.02",
        "0.0004, 0.02, 0.00 +- 0.02",
        "-0.0004, 0.02, 0.00 +- 0.02",
        "12345, 250, 12300 +- 300",
        "0.0000124, 0.0000003, (1.24 +- 0.03)e-5",
        "2.5e7, 4e5, (2.50 +- 0.04)e7",
        "3.14159, 0, 3.14",
        "3.14159, NaN, 3.14",
    })
    void aValueHasNoDigitsBeyondItsDeviation(double value, double deviation, String text) {
        assertThat(Numbers.uncertain(value, deviation)).isEqualTo(text);
    }

    @ParameterizedTest
    @CsvSource({
        "0.8345, 0.83", "0.0099999, 0.010", "0.01, 0.010", "1234.4, 1234", "-7.77, -7.8",
        "0.000321, 3.2e-4", "4.56e9, 4.6e9", "0, 0", "NaN, unknown", "Infinity, infinite",
        "-Infinity, minus infinity", "0.001, 0.0010",
    })
    void errorsHaveTwoDigits(double value, String text) {
        assertThat(Numbers.rounded(value)).isEqualTo(text);
    }

    @ParameterizedTest
    @CsvSource({
        "0.9912, 99.1 %",
        "0.99991, more than 99.9 %",
        "1, more than 99.9 %",
        "0.9994, 99.9 %",
        "0, 0.0 %",
        "0.0004, less than 0.1 %",
        "-0.02, -2.0 %",
    })
    void sharesAreInPercent(double share, String text) {
        assertThat(Numbers.percent(share)).isEqualTo(text);
    }

    /** Of several sets none is certain: 1 is what was rounded to it. */
    @ParameterizedTest
    @CsvSource({"0.9251, 92.5 %", "0.9996, > 99.9 %", "1, > 99.9 %", "0.0004, < 0.1 %"})
    void probabilitiesAreInPercent(double value, String text) {
        assertThat(Numbers.probability(value)).isEqualTo(text);
    }
}
