package org.auvsim.server.feedback;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.apache.commons.math3.linear.RealMatrix;
import org.auvsim.auvsml.message.feedback.Covariance;
import org.auvsim.auvsml.message.feedback.Measurement;
import org.auvsim.auvsml.message.feedback.MeasurementFrame;
import org.auvsim.core.math.Quat;
import org.auvsim.core.math.Vec3;
import org.junit.jupiter.api.Test;

import java.util.Optional;

/** What a measurement in any axes says in the world's. */
class TargetTest {
    private static final Vec3 UP = new Vec3(0, 0, 1);

    /** At (10, 20, -5), its nose to the north, that is along y. */
    private static final RigidMotion NORTHBOUND =
            new RigidMotion(
                    new Vec3(10, 20, -5),
                    Quat.ofAxisAngle(UP, Math.PI / 2),
                    new Vec3(0, 2, 0),
                    Vec3.ZERO);

    private static Target target(
            MeasurementFrame frame,
            Vec3 position,
            Quat orientation,
            Vec3 velocity,
            Vec3 angularVelocity) {
        return target(frame, position, orientation, velocity, angularVelocity, Optional.empty());
    }

    private static Target target(
            MeasurementFrame frame,
            Vec3 position,
            Quat orientation,
            Vec3 velocity,
            Vec3 angularVelocity,
            Optional<Covariance> covariance) {
        return Target.of(
                new Measurement(
                        frame,
                        Optional.of(position),
                        Optional.of(orientation),
                        Optional.of(velocity),
                        Optional.of(angularVelocity),
                        covariance),
                NORTHBOUND);
    }

    /** A target of which velocity and, maybe, orientation were measured alone. */
    private static Target moving(
            MeasurementFrame frame, Optional<Quat> orientation, Vec3 velocity) {
        return Target.of(
                new Measurement(
                        frame,
                        Optional.empty(),
                        orientation,
                        Optional.of(velocity),
                        Optional.empty(),
                        Optional.empty()),
                NORTHBOUND);
    }

    private static void assertNear(Optional<Vec3> is, double x, double y, double z) {
        assertThat(is.orElseThrow().distance(new Vec3(x, y, z))).isLessThan(1e-14);
    }

    /** Where nose and top of a body point. */
    private static void assertPoints(Target target, Vec3 nose, Vec3 top) {
        Quat orientation = target.orientation().orElseThrow();
        assertThat(orientation.rotate(new Vec3(1, 0, 0)).distance(nose)).isLessThan(1e-14);
        assertThat(orientation.rotate(UP).distance(top)).isLessThan(1e-14);
    }

    @Test
    void theWorldsAxesAreTakenAsTheyAre() {
        Target target =
                target(
                        MeasurementFrame.WORLD,
                        new Vec3(1, 2, 3),
                        Quat.IDENTITY,
                        new Vec3(4, 5, 6),
                        new Vec3(7, 8, 9));
        assertNear(target.position(), 1, 2, 3);
        assertNear(target.velocity(), 4, 5, 6);
        assertNear(target.angularVelocity(), 7, 8, 9);
        assertPoints(target, new Vec3(1, 0, 0), UP);
    }

    /** 1 m north, 2 m east, 3 m deep; the identity is level with the nose to the north. */
    @Test
    void northEastDownBecomesEastNorthUp() {
        Target target =
                target(
                        MeasurementFrame.NED,
                        new Vec3(1, 2, 3),
                        Quat.IDENTITY,
                        new Vec3(4, 5, 6),
                        new Vec3(0, 0, 1));
        assertNear(target.position(), 2, 1, -3);
        assertNear(target.velocity(), 5, 4, -6);
        assertNear(target.angularVelocity(), 0, 0, -1);
        assertPoints(target, new Vec3(0, 1, 0), UP);
    }

    /** A yaw of 90 degrees in north, east, down points the nose to the east. */
    @Test
    void headingsTurnClockwiseFromTheNorth() {
        Target target =
                target(
                        MeasurementFrame.NED,
                        Vec3.ZERO,
                        Quat.ofAxisAngle(UP, Math.PI / 2),
                        Vec3.ZERO,
                        Vec3.ZERO);
        assertPoints(target, new Vec3(1, 0, 0), UP);
    }

    /** 1 m ahead and 2 m to the left of the model, turned left by another 90 degrees. */
    @Test
    void bodyAxesAreThoseOfTheModelAndOfTheRobotForItsVelocities() {
        Target target =
                target(
                        MeasurementFrame.BODY,
                        new Vec3(1, 2, 0.5),
                        Quat.ofAxisAngle(UP, Math.PI / 2),
                        new Vec3(3, 0, 0),
                        new Vec3(0.1, 0, 0.2));
        assertNear(target.position(), 8, 21, -4.5);
        assertNear(target.velocity(), -3, 0, 0);
        assertNear(target.angularVelocity(), -0.1, 0, 0.2);
        assertPoints(target, new Vec3(-1, 0, 0), UP);
    }

    @Test
    void withoutAnOrientationTheRobotsAxesAreTheModels() {
        Target target = moving(MeasurementFrame.BODY, Optional.empty(), new Vec3(3, 0, 0));
        assertNear(target.velocity(), 0, 3, 0);
    }

    /** Unsure of the north by 3, of the east by 2: in the world, of y and x. */
    @Test
    void aCovarianceTurnsWithItsAxes() {
        double[] variances = new double[12];
        for (int i = 0; i < 12; i++) {
            variances[i] = i + 1;
        }
        variances[0] = 9;
        Target target =
                target(
                        MeasurementFrame.NED,
                        Vec3.ZERO,
                        Quat.IDENTITY,
                        Vec3.ZERO,
                        Vec3.ZERO,
                        Optional.of(Covariance.diagonal(variances)));
        RealMatrix covariance = target.covariance().orElseThrow();
        double[] expected = {2, 9, 3, 5, 4, 6, 8, 7, 9, 11, 10, 12};
        for (int i = 0; i < 12; i++) {
            for (int j = 0; j < 12; j++) {
                double element = i == j ? expected[i] : 0;
                assertThat(covariance.getEntry(i, j)).isCloseTo(element, within(1e-13));
            }
        }
    }

    /** The model moves and turns on until the end of the step: so does the robot. */
    @Test
    void theModelsMotionIsAddedToAnEarlierMeasurement() {
        RigidMotion later =
                new RigidMotion(
                        new Vec3(10, 22, -5),
                        Quat.ofAxisAngle(UP, Math.PI),
                        new Vec3(-2, 0, 0),
                        new Vec3(0, 0, 1));
        Target target =
                target(
                                MeasurementFrame.WORLD,
                                new Vec3(11, 20, -5),
                                Quat.IDENTITY,
                                new Vec3(1, 0, 0),
                                Vec3.ZERO)
                        .carried(NORTHBOUND, later);
        assertNear(target.position(), 11, 22, -5);
        assertNear(target.velocity(), -1, -2, 0);
        assertNear(target.angularVelocity(), 0, 0, 1);
        assertPoints(target, new Vec3(0, 1, 0), UP);
    }

    @Test
    void errorsAreThereForWhatWasMeasured() {
        Target target =
                moving(MeasurementFrame.WORLD, Optional.of(Quat.IDENTITY), new Vec3(3, 6, 0));
        MeasurementErrors errors = target.errors(NORTHBOUND);
        assertThat(errors.position()).isEmpty();
        assertThat(errors.angle().orElseThrow()).isCloseTo(Math.PI / 2, within(1e-15));
        assertThat(errors.velocity()).hasValue(5);
        assertThat(errors.angularVelocity()).isEmpty();
    }
}
