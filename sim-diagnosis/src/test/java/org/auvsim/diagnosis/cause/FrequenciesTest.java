package org.auvsim.diagnosis.cause;

import static org.assertj.core.api.Assertions.assertThat;

import org.auvsim.diagnosis.model.BelievedModel;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

import java.util.List;

/** Frequencies at which what swings is begun. */
class FrequenciesTest {
    private static final double WORST_LEFT = 0.65;

    /**
     * Half way between two of them a swing is still mostly seen: sin(a)/a of its amplitude, a being
     * half of the angle by which it parts from the nearer one over a run.
     */
    @ParameterizedTest
    @CsvSource({
        "current_oscillating, 200", "current_oscillating, 400", "current_oscillating, 1200",
        "periodic_force, 200", "periodic_force, 400", "periodic_force, 1200",
    })
    void areSoNearToEachOtherThatNoneIsLostBetween(String id, int samples) {
        BelievedModel model = Tank.model("", "");
        List<Double> all =
                Library.of(model, List.of(Tank.run(model, samples))).stream()
                        .filter(of -> of.id().equals(id))
                        .flatMap(of -> of.guesses(List.of(Tank.run(model, samples))).stream())
                        .map(guess -> guess.theta().getLast())
                        .toList();
        double duration = (samples - 1) * Tank.SPACING;
        for (int i = 1; i < all.size(); i++) {
            double apart = (all.get(i) - all.get(i - 1)) / 2 * duration / 2;
            assertThat(Math.sin(apart) / apart).isGreaterThan(WORST_LEFT);
        }
    }
}
