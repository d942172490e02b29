package org.auvsim.diagnosis.result;

import static org.assertj.core.api.Assertions.assertThat;

import org.auvsim.diagnosis.cause.Quantity;
import org.auvsim.diagnosis.run.MeasuredRun;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

import java.util.List;
import java.util.Optional;

class MomentsTest {
    private static final double UNIX = 1_718_000_000;

    private static MeasuredRun run(String name, double begin) {
        return MeasuredRun.named(name)
                .at(begin)
                .position(0, 0, 0)
                .at(begin + 20)
                .position(1, 0, 0)
                .build();
    }

    private static QuantityGroup seconds(String name, double value) {
        return new QuantityGroup(name, "s", false, List.of(value), List.of(0.02));
    }

    private static Moments of(double begin) {
        return new Moments(List.of(run("b", begin + 400), run("a", begin)));
    }

    @Test
    void farFrom0TimesAreToldFromTheStartOfTheirRun() {
        assertThat(of(UNIX).text(seconds("from", UNIX + 430.05)))
                .isEqualTo("30.05 +- 0.02 s after the start of b");
        assertThat(of(UNIX).text(seconds("at", UNIX + 3))).endsWith(" s after the start of a");
        assertThat(of(UNIX).text(seconds("at", UNIX - 3)))
                .isEqualTo("-3.00 +- 0.02 s after the start of a");
        assertThat(of(UNIX).text(UNIX + 403.21, "b")).isEqualTo("3.21 s after the start of b");
        assertThat(of(UNIX).begin()).isEqualTo(UNIX);
    }

    @Test
    void whatMayHaveBeenThereFromTheBeginningIsToldSo() {
        assertThat(of(5).text(seconds("from", 5.03)))
                .isEqualTo("5.03 +- 0.02 s or from the beginning on");
        assertThat(of(5).text(seconds("from", 5.05))).isEqualTo("5.05 +- 0.02 s");
        assertThat(of(5).text(seconds("at", 5.03))).isEqualTo("5.03 +- 0.02 s");
        assertThat(of(UNIX).text(seconds("from", UNIX)))
                .isEqualTo("0.00 +- 0.02 s after the start of a or from the beginning on");
    }

    @Test
    void near0AndOfDurationsAllIsToldAsItIs() {
        assertThat(of(0).text(seconds("from", 430.05))).isEqualTo("430.05 +- 0.02 s");
        assertThat(of(0).text(403.21, "b")).isEqualTo("403 s of b");
        assertThat(of(UNIX).text(seconds("tau", 0.5))).isEqualTo("0.50 +- 0.02 s");
    }

    /** Where a clock is far from 0 the world of what depends on it must begin there, too. */
    @ParameterizedTest
    @CsvSource({
        "thruster_fade, fade, 1/s, true",
        "step_force, from, s, true",
        "wave_forcing, omega, rad/s, true",
        "thruster_lag, tau, s, false",
        "thruster_advance, loss, s/m, false"
    })
    void someCausesDependOnTheWorldsTime(String cause, String name, String unit, boolean isTimed) {
        Finding found =
                new Finding(
                        cause,
                        Optional.empty(),
                        List.of(new Quantity(name, unit, 0.5)),
                        List.of(0.1),
                        1,
                        true);
        assertThat(Moments.isTimed(found)).isEqualTo(isTimed);
    }
}
