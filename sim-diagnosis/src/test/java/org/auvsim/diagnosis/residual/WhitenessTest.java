package org.auvsim.diagnosis.residual;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.apache.commons.math3.distribution.ChiSquaredDistribution;
import org.apache.commons.math3.distribution.NormalDistribution;
import org.auvsim.diagnosis.run.MeasuredRun;
import org.auvsim.diagnosis.run.MeasuredRunBuilder;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

import java.util.List;
import java.util.Random;

/** The deviate of a chi square against both distributions: it is as rare as it says. */
class WhitenessTest {
    /** Of a fix of the position in every tenth row. */
    @Test
    void noiseInSomeRowsIsNoise() {
        Random random = new Random(4);
        MeasuredRunBuilder builder = MeasuredRun.named("run");
        double[] fixes = new double[4000];
        for (int k = 0; k < fixes.length; k++) {
            fixes[k] = k % 10 == 0 ? random.nextGaussian() : 0;
            builder.at(0.1 * k)
                    .position(k % 10 == 0 ? fixes[k] : Double.NaN, Double.NaN, Double.NaN);
        }
        MeasuredRun run = builder.build();

        double largest = Whiteness.largest(fixes, new Misses(run, Noise.of(List.of(run))));

        assertThat(largest).isLessThan(2);
    }

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
