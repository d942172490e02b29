package org.auvsim.diagnosis.result;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

import java.util.List;

class QuantityGroupTest {
    private static String text(List<Double> values, List<Double> deviations) {
        return new QuantityGroup("u", "m/s", values.size() > 1, values, deviations).text();
    }

    @Test
    void aVectorHasItsDeviationsAndItsUnit() {
        assertThat(text(List.of(0.12, -0.07, 0.3), List.of(0.01, 0.01, 0.2)))
                .isEqualTo("(0.120 +- 0.010, -0.070 +- 0.010, 0.3 +- 0.2) m/s");
    }

    /** A boat of which the height is not measured. */
    @Test
    void ofAComponentThatTheDataDoesNotTellNoNumberIsTold() {
        assertThat(text(List.of(0.12, -0.07, 231.0), List.of(0.01, 0.01, 3e5)))
                .isEqualTo("(0.120 +- 0.010, -0.070 +- 0.010, not determined) m/s");
    }

    /** A body that is held to x. */
    @Test
    void ofWhatLeavesNoTraceNoNumberIsTold() {
        List<Double> deviations = List.of(0.01, Double.NaN, Double.NaN);
        assertThat(text(List.of(0.12, 0.0, 0.0), deviations))
                .isEqualTo("(0.120 +- 0.010, not determined, not determined) m/s");
        assertThat(
                        new QuantityGroup("u", "m/s", true, List.of(0.12, 0.0, 0.0), deviations)
                                .toldDeviations())
                .isEqualTo(deviations);
        assertThat(text(List.of(0.1), List.of(Double.NaN))).isEqualTo("not determined");
    }

    /** As of a current of a boat that is held at its height. */
    @Test
    void whatRoundingLeavesIsZero() {
        assertThat(text(List.of(0.12, -0.07, 1.97e-20), List.of(0.01, 0.01, 0.0)))
                .isEqualTo("(0.120 +- 0.010, -0.070 +- 0.010, 0) m/s");
    }

    /** Of what explains nothing no deviations are known. */
    @Test
    void withoutDeviationsNoNumberIsToldOfWhatIsNone() {
        assertThat(text(List.of(0.12, Double.NaN, Double.NaN), List.of()))
                .isEqualTo("(0.120, not determined, not determined) m/s");
    }

    /** A phase at the world's time 0, of a swing that was seen long after that. */
    @Test
    void anAngleThatMayBeAnyIsNotTold() {
        assertThat(phase(2.9)).isEqualTo("1 +- 3 rad");
        assertThat(phase(3.2)).isEqualTo("not determined");
    }

    private static String phase(double deviation) {
        return new QuantityGroup("phase", "rad", false, List.of(1.0), List.of(deviation)).text();
    }

    @Test
    void whereNothingIsSureAllIsTold() {
        assertThat(text(List.of(0.12, 1.0), List.of(2.0, 30.0))).doesNotContain("not determined");
    }
}
