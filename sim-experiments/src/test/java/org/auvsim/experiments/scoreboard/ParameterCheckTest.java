package org.auvsim.experiments.scoreboard;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;
import static org.assertj.core.api.Assertions.withinPercentage;

import org.auvsim.diagnosis.cause.Quantity;
import org.auvsim.diagnosis.result.Finding;
import org.junit.jupiter.api.Test;

import java.util.List;
import java.util.Map;
import java.util.Optional;

class ParameterCheckTest {
    private static Finding found(String cause, List<Quantity> quantities, Double... deviations) {
        return new Finding(cause, Optional.empty(), quantities, List.of(deviations), 1, true);
    }

    private static Finding current(double x, double y, double z, double deviation) {
        return found(
                "current_constant",
                List.of(
                        new Quantity("u.x", "m/s", x),
                        new Quantity("u.y", "m/s", y),
                        new Quantity("u.z", "m/s", z)),
                deviation,
                deviation,
                deviation);
    }

    @Test
    void aVectorCountsByItsLength() {
        ParameterCheck check =
                ParameterCheck.of(Map.of("u", List.of(0.3, 0.4, 0.0)), current(0.3, 0.45, 0, 0.01));

        assertThat(check.errors()).singleElement().satisfies(e -> close(e, 0.1));
        assertThat(check.stated()).isEqualTo(3);
        assertThat(check.covered()).isEqualTo(2);
    }

    @Test
    void aSwingToldTheOtherWayRoundIsTheSame() {
        ParameterCheck check =
                ParameterCheck.of(
                        Map.of(
                                "force",
                                List.of(1.0, 0.0, 2.0),
                                "omega",
                                List.of(0.5),
                                "phase",
                                List.of(0.2)),
                        found(
                                "periodic_force",
                                List.of(
                                        new Quantity("force.x", "N", -1),
                                        new Quantity("force.y", "N", 0),
                                        new Quantity("force.z", "N", -2),
                                        new Quantity("omega", "rad/s", 0.5),
                                        new Quantity("phase", "rad", 0.2 - Math.PI))));

        assertThat(check.errors()).hasSize(3).allSatisfy(e -> close(e, 0));
        assertThat(check.stated()).isZero();
        assertThat(check.expected()).isEmpty();
    }

    /** The medians of the chi distributions of 1 and 3 degrees of freedom are 0.6745 and 1.5382. */
    @Test
    void whatDeviationsLeaveIsTheMedianOfErrorsOfThatSize() {
        ParameterCheck one =
                ParameterCheck.of(
                        Map.of("k", List.of(2.0)),
                        found("quadratic_drag", List.of(new Quantity("k", "kg/m", 2)), 0.1));
        ParameterCheck three =
                ParameterCheck.of(Map.of("u", List.of(0.0, 2.0, 0.0)), current(0, 2, 0, 0.1));

        assertThat(one.expected())
                .singleElement()
                .satisfies(e -> assertThat(e).isCloseTo(0.6745 * 0.05, withinPercentage(2)));
        assertThat(three.expected())
                .singleElement()
                .satisfies(e -> assertThat(e).isCloseTo(1.5382 * 0.05, withinPercentage(2)));
    }

    private static void close(double error, double expected) {
        assertThat(error).isCloseTo(expected, within(1e-12));
    }
}
