package org.auvsim.experiments.cfs;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;
import static org.assertj.core.api.Assertions.withinPercentage;

import org.auvsim.experiments.Conduct;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class GrowthTest {
    private static final Conduct CONDUCT = new Conduct(true, _ -> {}, () -> false);

    /** The same motion in closed form, step by step: 1 kg, 1 N beyond 2 m, 1 m/s in the middle. */
    private static double farthest(double dt, double until) {
        double y = 0;
        double v = 1;
        double farthest = 0;
        for (int k = 0; k < Math.round(until / dt); k++) {
            double a = Math.abs(y) > 2 ? -Math.signum(y) : 0;
            y += v * dt + a * dt * dt / 2;
            v += a * dt;
            farthest = Math.max(farthest, Math.abs(y));
        }
        return farthest;
    }

    @ParameterizedTest
    @CsvSource({"0.05, 200", "0.01, 200"})
    void theTurningPointsGrowAsInClosedForm(double timeStep, double until) {
        Growth growth = Growth.of(timeStep, until, CONDUCT);
        assertThat(growth.turns()).hasSizeGreaterThan(20);
        double farthest = growth.turns().stream().mapToDouble(p -> p.y()).max().orElseThrow();
        // Where it is at the limit but for rounding, rounding decides whether it is pushed.
        assertThat(farthest)
                .isCloseTo(farthest(timeStep, growth.turns().getLast().x()), withinPercentage(5));
        assertThat(growth.last()).isGreaterThan(growth.first());
    }

    @ParameterizedTest
    @CsvSource({"0.05, 23.4", "0.01, 5.5"})
    void aThousandSecondsOfSmallerStepsGoLessFar(double timeStep, double farthest) {
        assertThat(Growth.of(timeStep, 1000, CONDUCT).last()).isCloseTo(farthest, within(0.1));
    }
}
