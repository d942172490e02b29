package org.auvsim.diagnosis.shooting;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.auvsim.core.math.Quat;
import org.auvsim.core.math.Vec3;
import org.auvsim.diagnosis.fit.Step;
import org.auvsim.diagnosis.model.BelievedModel;
import org.auvsim.diagnosis.subject.MeasuredVehicle;
import org.auvsim.server.feedback.RigidMotion;
import org.junit.jupiter.api.Test;

import java.util.Arrays;
import java.util.List;
import java.util.Optional;

/** How far a step turns windows, and that it is shortened where that is no longer linear. */
class WindowBlockTest {
    private static final int ROLL = 3;
    private static final int YAW_RATE = 11;
    private static final double LENGTH = 2;

    /** Standard deviations by which a start misses that is off by one. */
    private static final double PRECISION = 1000;

    private static final RigidMotion REST =
            new RigidMotion(Vec3.ZERO, Quat.IDENTITY, Vec3.ZERO, Vec3.ZERO);

    /** A free body's only window, 2 s long, which asks for another number of its start. */
    private static WindowBlock asking(int number, double change) throws Exception {
        BelievedModel model = MeasuredVehicle.model(0.025);
        double[] misses = new double[RigidMotion.SIZE];
        misses[number] = -PRECISION * change;
        double[][] slopes = new double[RigidMotion.SIZE][RigidMotion.SIZE];
        double[][] endSlopes = new double[RigidMotion.SIZE][RigidMotion.SIZE];
        for (int i = 0; i < RigidMotion.SIZE; i++) {
            slopes[i][i] = PRECISION;
            endSlopes[i][i] = 1;
            if (i >= RigidMotion.SIZE / 2) {
                endSlopes[i][i - RigidMotion.SIZE / 2] = LENGTH;
            }
        }
        boolean[] shown = new boolean[RigidMotion.SIZE];
        Arrays.fill(shown, true);
        RigidMotion[] motion = {REST, REST};
        Window window = new Window(0, 1, REST);
        return new WindowBlock(
                model,
                List.of(new WindowDerivatives(window, motion, misses, slopes, endSlopes)),
                shown,
                Optional.empty());
    }

    @Test
    void aTurnOfTheStartCounts() throws Exception {
        assertThat(asking(ROLL, 0.4).largestTurn(new double[0])).isCloseTo(0.4, within(1e-3));
    }

    @Test
    void soDoesWhatARateMakesOfItByTheEnd() throws Exception {
        assertThat(asking(YAW_RATE, 0.4).largestTurn(new double[0])).isCloseTo(0.8, within(1e-3));
    }

    @Test
    void aSmallStepIsMadeWhole() throws Exception {
        assertThat(yawRateAfter(0.3)).isCloseTo(0.3, within(1e-3));
    }

    @Test
    void aStepThatSpinsTheEndIsShortened() throws Exception {
        assertThat(yawRateAfter(7) * LENGTH).isCloseTo(0.7, within(1e-3));
    }

    private static double yawRateAfter(double asked) throws Exception {
        return Step.windows(List.of(List.of(asking(YAW_RATE, asked))), new double[0])
                .getFirst()
                .getFirst()
                .start()
                .angularVelocity()
                .z();
    }
}
