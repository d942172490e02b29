package org.auvsim.server.simulator;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;

import java.util.OptionalDouble;
import java.util.OptionalLong;

class PaceTest {
    private long now = 123;

    private Pace pace(double rate) {
        Pace pace = new Pace(OptionalDouble.of(rate), () -> now);
        pace.start(10);
        return pace;
    }

    private void pass(double seconds) {
        now += (long) (seconds * 1e9);
    }

    @Test
    void aStepIsDueWhenItsTimeHasComeAtTheRate() {
        Pace pace = pace(2);
        assertThat(pace.nanosUntil(10)).isZero();
        assertThat(pace.nanosUntil(11)).isEqualTo(500_000_000);
        pass(0.4);
        assertThat(pace.nanosUntil(11)).isEqualTo(100_000_000);
    }

    @Test
    void asFastAsPossibleIsAlwaysDueAndNeverLate() {
        Pace pace = new Pace(OptionalDouble.empty(), () -> now);
        pass(100);
        assertThat(pace.nanosUntil(1e6)).isZero();
        assertThat(pace.skipWhatIsLost(0)).isZero();
    }

    @Test
    void aClockThatGoesBackHoldsNothingUp() {
        Pace pace = pace(1);
        pass(0.5);
        assertThat(pace.nanosUntil(11)).isEqualTo(500_000_000);
        pass(-3600);
        assertThat(pace.nanosUntil(11)).isEqualTo(500_000_000);
        pass(0.2);
        assertThat(pace.nanosUntil(11)).isEqualTo(300_000_000);
    }

    @Test
    void aShortDelayIsCaughtUpWithALongOneIsSkipped() {
        Pace pace = pace(2);
        pass(0.4);
        assertThat(pace.skipWhatIsLost(10)).isZero();
        pass(0.6);
        assertThat(pace.skipWhatIsLost(10)).isCloseTo(2, within(1e-9));
        assertThat(pace.nanosUntil(10)).isZero();
        assertThat(pace.nanosUntil(11)).isEqualTo(500_000_000);
    }

    @Test
    void lagIsToldOnceInAWhileAndAddsUp() {
        Lag lag = new Lag(pace(1));
        assertThat(lag.skippedSteps(10, 0.05)).isEmpty();
        pass(1);
        assertThat(lag.skippedSteps(10, 0.05)).isEqualTo(OptionalLong.of(20));
        pass(1);
        assertThat(lag.skippedSteps(10, 0.05)).isEmpty();
        pass(4.5);
        assertThat(lag.skippedSteps(10, 0.05)).isEqualTo(OptionalLong.of(110));
    }

    @Test
    void aRateIsPositive() {
        assertThatThrownBy(() -> pace(0))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessage("the rate must be above 0 world seconds a second, but is 0.0");
    }
}
