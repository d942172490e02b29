package org.auvsim.diagnosis.fit;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.apache.commons.math3.distribution.ChiSquaredDistribution;
import org.apache.commons.math3.distribution.NormalDistribution;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** The deviate of a chi square against both distributions: it is as rare as it says. */
class WhitenessTest {
    @ParameterizedTest(name = "1 in 10 to the {1} of {0}")
    @CsvSource({"2, 2", "2, 5", "8, 3", "8, 5", "30, 5", "300, 5"})
    void aDeviateIsAsRareAsItsChiSquare(int freedom, int digits) {
        double rare = Math.pow(10, -digits);
        double chiSquare =
                new ChiSquaredDistribution(freedom).inverseCumulativeProbability(1 - rare);
        double deviate = new NormalDistribution().inverseCumulativeProbability(1 - rare);

        assertThat(Whiteness.deviate(chiSquare, freedom)).isCloseTo(deviate, within(0.2));
    }
}
