package org.auvsim.core.sensor;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.auvsim.core.math.Quat;
import org.auvsim.core.math.Vec3;
import org.junit.jupiter.api.Test;

class KinematicsTest {
    private static final Vec3 SPIN = new Vec3(0.6, -0.3, 0.9);

    /** A circle of 2 m at 1 rad/s, turning at a constant rate. */
    private static Kinematics circle(double t) {
        return new Kinematics(
                t,
                new Vec3(2 * Math.cos(t), 2 * Math.sin(t), 0),
                Quat.ofAxisAngle(SPIN, SPIN.norm() * t),
                new Vec3(-2 * Math.sin(t), 2 * Math.cos(t), 0),
                SPIN);
    }

    @Test
    void betweenTwoStatesItErrsByTheFourthOrder() {
        double coarse = error(0.2);
        double fine = error(0.1);

        assertThat(fine).isBetween(coarse / 40, coarse / 12);
        assertThat(error(0.05)).isLessThan(2e-7);
    }

    private static double error(double h) {
        Kinematics between = circle(1).toward(circle(1 + h), 1 + 0.4 * h);
        return between.position().distance(circle(1 + 0.4 * h).position());
    }

    @Test
    void orientationAndVelocitiesAreThoseOfTheCurve() {
        Kinematics between = circle(1).toward(circle(1.05), 1.02);
        Kinematics exact = circle(1.02);

        assertThat(between.time()).isEqualTo(1.02);
        assertThat(between.velocity().distance(exact.velocity())).isLessThan(2e-5);
        assertThat(between.angularVelocity().distance(SPIN)).isLessThan(2e-5);
        Vec3 ahead = new Vec3(1, 2, 3);
        assertThat(between.orientation().rotate(ahead).distance(exact.orientation().rotate(ahead)))
                .isLessThan(1e-6);
    }

    @Test
    void theSignOfTheQuaternionDoesNotMatter() {
        Kinematics end = circle(1.05);
        Quat q = end.orientation();
        Kinematics mirrored =
                new Kinematics(
                        end.time(),
                        end.position(),
                        new Quat(-q.w(), -q.x(), -q.y(), -q.z()),
                        end.velocity(),
                        end.angularVelocity());

        assertThat(circle(1).toward(mirrored, 1.02)).isEqualTo(circle(1).toward(end, 1.02));
    }

    @Test
    void aPlaceOfTheBodyMovesWithIt() {
        Kinematics body =
                new Kinematics(
                        0,
                        new Vec3(1, 1, 1),
                        Quat.ofAxisAngle(new Vec3(0, 0, 1), Math.PI / 2),
                        new Vec3(1, 0, 0),
                        new Vec3(0, 0, 2));

        Kinematics nose = body.at(new Vec3(0.5, 0, 0), Quat.IDENTITY);

        assertThat(nose.position().distance(new Vec3(1, 1.5, 1))).isCloseTo(0, within(1e-15));
        assertThat(nose.velocity().distance(Vec3.ZERO)).isCloseTo(0, within(1e-15));
    }
}
