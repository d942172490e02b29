package org.auvsim.diagnosis.shaking;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.auvsim.diagnosis.run.MeasuredRun;
import org.auvsim.diagnosis.run.MeasuredRunBuilder;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import java.util.List;

class ShakeTest {
    private static final int MANY = 40_000;

    private static double strength(MeasuredRun run) {
        return Shake.of(run, Rotor.MODEL).orElseThrow().strength();
    }

    /** The covariance of a rotor that is out of balance, by its own equations. */
    @ParameterizedTest(name = "level {0}")
    @ValueSource(doubles = {0.3, 0.6, 1})
    void anImbalanceIsTheSameWhateverTheThrust(double level) {
        Rotor rotor = new Rotor(0.02, 0.1);

        assertThat(strength(rotor.run(1, MANY, level)) / rotor.strength())
                .isCloseTo(1, within(0.15));
    }

    @Test
    void whatSensorsDoNotShareIsNone() {
        double shaken = strength(new Rotor(0.02, 0.1).run(2, MANY, 0.5));

        assertThat(strength(new Rotor(0, 0.1).run(2, MANY, 0.5)) / shaken)
                .isCloseTo(0, within(0.05));
    }

    /** A vehicle that speeds up and turns as it likes does not shake by that. */
    @Test
    void aMotionIsNone() {
        MeasuredRunBuilder run = MeasuredRun.named("run").commands(List.of("main"));
        for (int k = 0; k < 200; k++) {
            run.at(0.05 * k).command(0, 0.5).shaking(3 + 0.2 * k, 1 - 0.1 * k);
        }

        assertThat(strength(run.build())).isCloseTo(0, within(1e-12));
    }

    /**
     * While thrust changes, or is small, or rows are not evenly spaced, sensors tell other things.
     */
    @Test
    void rowsOfOtherThrustAreLeftOut() {
        Rotor rotor = new Rotor(0.02, 0);
        MeasuredRun run =
                rotor.run(
                        3,
                        MANY,
                        k -> k % 100 < 10 ? 0.2 : 0.5,
                        k -> k % 100 == 10 || k % 100 == 5 ? 1e3 : 0,
                        1);

        assertThat(strength(run) / rotor.strength()).isGreaterThan(100);
        MeasuredRun quiet =
                rotor.run(
                        3,
                        MANY,
                        k -> k % 100 < 10 ? 0.2 : 0.5,
                        k -> k % 100 > 1 && k % 100 < 9 ? 1e3 : 0,
                        1);
        assertThat(strength(quiet) / rotor.strength()).isCloseTo(1, within(0.15));
    }

    @Test
    void rowsAtUnevenTimesAreLeftOut() {
        MeasuredRunBuilder run = MeasuredRun.named("run").commands(List.of("main"));
        for (int k = 0; k < 200; k++) {
            run.at(0.05 * k + (k % 2 == 0 ? 0 : 0.01)).command(0, 0.5).shaking(k % 2, k % 2);
        }

        assertThat(Shake.of(run.build(), Rotor.MODEL)).isEmpty();
    }

    @Test
    void withoutThrustNothingIsTold() {
        assertThat(Shake.of(new Rotor(0.02, 0.1).run(4, 200, 0), Rotor.MODEL)).isEmpty();
        assertThat(Shake.of(new Rotor(0.02, 0.1).run(4, 17, 0.5), Rotor.MODEL)).isEmpty();
        assertThat(Shake.of(new Rotor(0.02, 0.1).run(4, 18, 0.5), Rotor.MODEL)).isPresent();
    }
}
