package org.auvsim.cli.export;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.auvsim.core.math.Quat;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

import java.util.Random;

class OrientationTest {
    @ParameterizedTest(name = "seed {0}")
    @ValueSource(longs = {1, 2, 3})
    void isTheQuaternionThatTheMatrixIsOf(long seed) {
        Random random = new Random(seed);
        for (int i = 0; i < 200; i++) {
            check(
                    new Quat(
                                    random.nextGaussian(),
                                    random.nextGaussian(),
                                    random.nextGaussian(),
                                    random.nextGaussian())
                            .normalized());
        }
    }

    /** Half turns, where one of the four squares alone is not small. */
    @ParameterizedTest
    @CsvSource({"1, 0, 0, 0", "0, 1, 0, 0", "0, 0, 1, 0", "0, 0, 0, 1", "1e-9, 0.6, 0, -0.8"})
    void holdsForHalfTurns(double w, double x, double y, double z) {
        check(new Quat(w, x, y, z).normalized());
    }

    private static void check(Quat expected) {
        Quat found = Orientation.of(expected.toMatrix());
        assertThat(found.w()).isNotNegative();
        double dot =
                found.w() * expected.w()
                        + found.x() * expected.x()
                        + found.y() * expected.y()
                        + found.z() * expected.z();
        assertThat(Math.abs(dot)).isCloseTo(1, within(1e-14));
    }
}
