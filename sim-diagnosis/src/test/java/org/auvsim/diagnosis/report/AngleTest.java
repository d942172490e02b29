package org.auvsim.diagnosis.report;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.auvsim.core.math.Quat;
import org.auvsim.core.math.Vec3;
import org.auvsim.diagnosis.model.Ensemble;
import org.auvsim.diagnosis.run.MeasuredRun;
import org.junit.jupiter.api.Test;

import java.util.Optional;

class AngleTest {
    private static final MeasuredRun RUN =
            MeasuredRun.named("run")
                    .at(0)
                    .orientation(turned(3))
                    .at(1)
                    .orientation(turned(4))
                    .build();

    private static Quat turned(double yaw) {
        return Quat.ofAxisAngle(new Vec3(0, 0, 1), yaw);
    }

    @Test
    void theMeasuredHeadingIsShownBesideThatOfTheModel() {
        assertThat(Angle.YAW.measured(RUN, Optional.of(turned(-3))))
                .containsExactly(new double[] {3 - 2 * Math.PI, 4 - 2 * Math.PI}, within(1e-12));
    }

    /** The orientation has the scenario's heading in a row that has roll and pitch alone. */
    @Test
    void whatWasNotMeasuredIsNotShown() {
        MeasuredRun run =
                MeasuredRun.named("run")
                        .at(0)
                        .orientation(turned(3))
                        .at(1)
                        .orientation(turned(0), true, true, false)
                        .at(2)
                        .orientation(turned(4))
                        .build();

        assertThat(Angle.YAW.measured(run, Optional.empty()))
                .containsExactly(new double[] {3, Double.NaN, 4}, within(1e-12));
        assertThat(Angle.ROLL.measured(run, Optional.empty()))
                .containsExactly(new double[] {0, 0, 0}, within(1e-12));
    }

    @Test
    void besideAModelThatGotLostItIsShownAsItIs() {
        assertThat(Angle.YAW.measured(RUN, Optional.of(Ensemble.LOST.orientation())))
                .containsExactly(new double[] {3, 4}, within(1e-12));
    }
}
