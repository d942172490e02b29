package org.auvsim.diagnosis.cause;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.auvsim.diagnosis.run.EulerAngles;
import org.auvsim.diagnosis.run.MeasuredRun;
import org.auvsim.diagnosis.run.MeasuredRunBuilder;
import org.junit.jupiter.api.Test;

import java.util.List;

/** A body that turns at 0.02 rad/s about the vertical, beginning with a heading of 1 rad. */
class TurningTest {
    private static final double RATE = 0.02;

    /** Its heading is measured in some rows, 0 in the others as in the scenario. */
    private static MeasuredRun run(int rows, int each) {
        MeasuredRunBuilder run = MeasuredRun.named("run");
        for (int k = 0; k < rows; k++) {
            boolean isMeasured = k % each == 0;
            double yaw = isMeasured ? 1 + RATE * 0.1 * k : 0;
            run.at(0.1 * k).orientation(EulerAngles.orientation(0, 0, yaw), true, true, isMeasured);
        }
        return run.build();
    }

    @Test
    void headingsInSomeRowsTellHowFastItTurns() {
        for (int each : List.of(1, 2, 7)) {
            assertThat(Turning.rate(List.of(run(600, each)))).isCloseTo(RATE, within(1e-9));
        }
    }

    /** What is never measured does not turn. */
    @Test
    void ofAHeadingThatIsMeasuredNeverNothingIsTold() {
        assertThat(Turning.rate(List.of(run(600, 700).part("part", 1, 599)))).isZero();
    }
}
