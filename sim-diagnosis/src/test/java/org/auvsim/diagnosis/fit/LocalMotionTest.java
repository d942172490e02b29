package org.auvsim.diagnosis.fit;

import static org.assertj.core.api.Assertions.assertThat;

import org.auvsim.core.math.Quat;
import org.auvsim.core.math.Vec3;
import org.auvsim.diagnosis.run.MeasuredRun;
import org.auvsim.diagnosis.run.MeasuredRunBuilder;
import org.auvsim.server.feedback.RigidMotion;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** The motion at a sample by those after it, of turns about a fixed axis. */
class LocalMotionTest {
    private static final Vec3 AXIS = new Vec3(2, -1, 4).normalized();

    /** Within the samples it turns round more than once. */
    @ParameterizedTest(name = "{0} rad/s")
    @ValueSource(doubles = {0.5, 6, 24})
    void ratesAreToldOfFastSpinsToo(double rate) {
        MeasuredRunBuilder run = MeasuredRun.named("disc");
        for (int k = 0; k < 40; k++) {
            run.at(0.02 * k)
                    .position(3 * 0.02 * k, 0, 0)
                    .orientation(Quat.ofAxisAngle(AXIS, 0.7 + rate * 0.02 * k));
        }
        MeasuredRun measured = run.build();
        RigidMotion otherwise = new RigidMotion(Vec3.ZERO, Quat.IDENTITY, Vec3.ZERO, Vec3.ZERO);

        RigidMotion at = LocalMotion.at(measured, otherwise, 0, 39);

        assertThat(at.angularVelocity().distance(AXIS.times(rate))).isLessThan(0.02 * rate);
        assertThat(at.velocity().distance(new Vec3(3, 0, 0))).isLessThan(1e-9);
    }
}
