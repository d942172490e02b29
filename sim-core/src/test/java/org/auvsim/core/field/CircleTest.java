package org.auvsim.core.field;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.auvsim.core.math.Draws;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class CircleTest {
    @ParameterizedTest(name = "seed {0}, up to {1}")
    @CsvSource({"1, 4, 4e-16", "2, 1000, 4e-16", "3, 1e6, 4e-16", "4, 1e9, 1e-7"})
    void sineAndCosineAreThoseOfTheAngle(long seed, double most, double error) {
        Draws draws = new Draws(seed);
        for (int k = 0; k < 1000; k++) {
            double angle = draws.number(-most, most);
            double quarters = Circle.quarters(angle);
            double rest = Circle.rest(angle, quarters);
            assertThat(Math.abs(rest)).isLessThan(0.7854 + error);
            double sin = StrictMath.sin(rest);
            double cos = StrictMath.cos(rest);
            assertThat(Circle.sine(quarters, sin, cos))
                    .isCloseTo(StrictMath.sin(angle), within(error));
            assertThat(Circle.sine(quarters + 1, sin, cos))
                    .isCloseTo(StrictMath.cos(angle), within(error));
        }
    }
}
