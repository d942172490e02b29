package org.auvsim.diagnosis.field;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.apache.commons.math3.linear.Array2DRowRealMatrix;
import org.apache.commons.math3.linear.ArrayRealVector;
import org.apache.commons.math3.linear.RealMatrix;
import org.apache.commons.math3.linear.RealVector;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import java.util.Random;

/** Weights that were drawn are found, and columns of which noise says nothing are not believed. */
class RegressionTest {
    private static final int ROWS = 120;
    private static final int COLUMNS = 20;
    private static final double NOISE = 0.5;

    private static RealMatrix columns(Random random) {
        RealMatrix columns = new Array2DRowRealMatrix(ROWS, COLUMNS);
        for (int r = 0; r < ROWS; r++) {
            for (int c = 0; c < COLUMNS; c++) {
                columns.setEntry(r, c, random.nextGaussian());
            }
        }
        return columns;
    }

    private static RealVector noise(Random random, double deviation) {
        RealVector noise = new ArrayRealVector(ROWS);
        for (int r = 0; r < ROWS; r++) {
            noise.setEntry(r, deviation * random.nextGaussian());
        }
        return noise;
    }

    @ParameterizedTest(name = "seed {0}")
    @ValueSource(longs = {1, 2, 3})
    void weightsAreFoundWithinTheNoise(long seed) {
        Random random = new Random(seed);
        RealMatrix columns = columns(random);
        double[] weights = random.doubles(COLUMNS, -2, 2).toArray();
        RealVector values = columns.operate(new ArrayRealVector(weights)).add(noise(random, NOISE));

        Regression regression = Regression.of(columns, values);

        assertThat(regression.evidence()).isGreaterThan(Regression.evidenceOfNothing(values) + 20);
        for (int c = 0; c < COLUMNS; c++) {
            assertThat(regression.weights().getEntry(c))
                    .isCloseTo(weights[c], within(4 * NOISE / Math.sqrt(ROWS)));
        }
    }

    @ParameterizedTest(name = "seed {0}")
    @ValueSource(longs = {1, 2, 3})
    void noiseIsNotImitated(long seed) {
        Random random = new Random(seed);
        RealMatrix columns = columns(random);
        RealVector values = noise(random, 3);

        Regression regression = Regression.of(columns, values);

        assertThat(regression.evidence()).isLessThan(Regression.evidenceOfNothing(values) + 2);
        assertThat(columns.operate(regression.weights()).getNorm())
                .isLessThan(0.35 * values.getNorm());
    }
}
