package org.auvsim.diagnosis.residual;

import static org.assertj.core.api.Assertions.assertThat;

import org.auvsim.core.entity.Frame;
import org.auvsim.core.math.Quat;
import org.auvsim.core.math.Vec3;
import org.auvsim.diagnosis.model.BelievedModel;
import org.auvsim.diagnosis.run.Channel;
import org.auvsim.diagnosis.run.EulerAngles;
import org.auvsim.diagnosis.run.KnownStart;
import org.auvsim.diagnosis.run.MeasuredRun;
import org.auvsim.diagnosis.run.MeasuredRunBuilder;
import org.auvsim.diagnosis.run.OrientationError;
import org.auvsim.diagnosis.subject.MeasuredVehicle;
import org.auvsim.server.feedback.RigidMotion;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Random;

/** The motion at a sample by those after it. */
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

    /** Three rows of 0.9 rad each: a line through them has 6 rad/s of noise, a parabola 22. */
    @Test
    void aFastSpinIsNotLostInNoise() {
        Random random = new Random(5);
        Vec3 spin = AXIS.times(46);
        double sum = 0;
        for (int c = 0; c < 100; c++) {
            MeasuredRunBuilder run = MeasuredRun.named("ball");
            for (int k = 0; k < 9; k++) {
                Quat off =
                        EulerAngles.orientation(
                                0.1 * random.nextGaussian(),
                                0.1 * random.nextGaussian(),
                                0.1 * random.nextGaussian());
                run.at(0.02 * k).orientation(off.times(Quat.ofAxisAngle(AXIS, 46 * 0.02 * k)));
            }
            RigidMotion still = new RigidMotion(Vec3.ZERO, Quat.IDENTITY, Vec3.ZERO, Vec3.ZERO);
            RigidMotion at = LocalMotion.at(run.build(), still, 0, 8);
            double error = at.angularVelocity().distance(spin);
            sum += error * error;
        }

        assertThat(Math.sqrt(sum / 100)).isLessThan(10);
    }

    /** Rows without a heading have that of the scenario, 0. */
    @Test
    void aHeadingThatSomeRowsLackIsThatOfTheOthers() {
        MeasuredRunBuilder run = MeasuredRun.named("run");
        for (int k = 0; k < 40; k++) {
            boolean isMeasured = k % 5 == 3;
            double yaw = isMeasured ? 1 + 0.3 * 0.1 * k : 0;
            run.at(0.1 * k)
                    .orientation(Quat.ofAxisAngle(new Vec3(0, 0, 1), yaw), true, true, isMeasured);
        }
        RigidMotion otherwise = new RigidMotion(Vec3.ZERO, Quat.IDENTITY, Vec3.ZERO, Vec3.ZERO);

        RigidMotion at = LocalMotion.at(run.build(), otherwise, 10, 30);

        Quat expected = Quat.ofAxisAngle(new Vec3(0, 0, 1), 1.3);
        assertThat(OrientationError.turn(expected, at.orientation()).norm()).isLessThan(1e-9);
        assertThat(at.angularVelocity().distance(new Vec3(0, 0, 0.3))).isLessThan(1e-9);
    }

    /** A diver that measures its depth and heading goes ahead as fast as the scenario has it. */
    @Test
    void whatWasNotMeasuredIsAsTheModelHasItAlongTheBodysAxes() {
        MeasuredRunBuilder run = MeasuredRun.named("dive");
        Quat east = Quat.ofAxisAngle(new Vec3(0, 0, 1), Math.PI / 2);
        for (int k = 0; k < 9; k++) {
            run.at(0.1 * k).position(Double.NaN, Double.NaN, -0.3 * 0.1 * k).orientation(east);
        }
        RigidMotion otherwise =
                new RigidMotion(new Vec3(5, 6, 7), Quat.IDENTITY, new Vec3(1.5, 0, 0), Vec3.ZERO);

        RigidMotion at = LocalMotion.at(run.build(), otherwise, 0, 8);

        assertThat(at.position().distance(new Vec3(5, 6, 0))).isLessThan(1e-9);
        assertThat(at.velocity().distance(new Vec3(0, 1.5, -0.3))).isLessThan(1e-9);
    }

    /** Of a boat the speed ahead and the rate of turning alone, now and then. */
    @Test
    void velocitiesThatAreMeasuredAlongSomeAxesCount() {
        MeasuredRunBuilder run =
                MeasuredRun.named("boat")
                        .frame(Channel.VELOCITY, Frame.BODY)
                        .frame(Channel.ANGULAR_VELOCITY, Frame.BODY);
        Quat north = Quat.ofAxisAngle(new Vec3(0, 0, 1), Math.PI / 2);
        for (int k = 0; k < 9; k++) {
            double ahead = k % 5 == 2 ? 1.5 : Double.NaN;
            run.at(0.1 * k)
                    .position(0, 0, 0)
                    .orientation(north)
                    .measured(Channel.VELOCITY, ahead, Double.NaN, Double.NaN)
                    .measured(Channel.ANGULAR_VELOCITY, Double.NaN, Double.NaN, 0.8);
        }
        RigidMotion still = new RigidMotion(Vec3.ZERO, Quat.IDENTITY, Vec3.ZERO, Vec3.ZERO);

        RigidMotion at = LocalMotion.at(run.build(), still, 0, 8);

        assertThat(at.velocity().distance(new Vec3(0, 1.5, 0))).isLessThan(1e-9);
        assertThat(at.angularVelocity().distance(new Vec3(0, 0, 0.8))).isLessThan(1e-9);
    }

    /** A fix a second on a circle: a parabola through all of it would lead nowhere. */
    @Test
    void aPathThatWindsTellsHowItBegins() {
        MeasuredRunBuilder run = MeasuredRun.named("boat");
        for (int k = 0; k <= 80; k++) {
            double yaw = 0.4 * 0.1 * k;
            boolean isFix = k % 10 == 0;
            run.at(0.1 * k)
                    .position(
                            isFix ? Math.sin(yaw) : Double.NaN,
                            isFix ? 1 - Math.cos(yaw) : Double.NaN,
                            0)
                    .orientation(Quat.ofAxisAngle(new Vec3(0, 0, 1), yaw));
        }
        RigidMotion still = new RigidMotion(Vec3.ZERO, Quat.IDENTITY, Vec3.ZERO, Vec3.ZERO);

        RigidMotion at = LocalMotion.at(run.build(), still, 0, 80);

        assertThat(at.velocity().distance(new Vec3(0.4, 0, 0))).isLessThan(0.1);
        assertThat(at.position().norm()).isLessThan(0.1);
    }

    @Test
    void whatIsNotKnownOfAStartIsAsItWasMeasuredOrAsTheModelHasIt() throws Exception {
        BelievedModel model = MeasuredVehicle.model(0.05);
        MeasuredRunBuilder run = MeasuredRun.named("drift");
        for (int k = 0; k < 9; k++) {
            run.at(0.1 * k).position(0.2 * 0.1 * k, 1, 0);
        }
        List<Double> deviations =
                new ArrayList<>(Collections.nCopies(12, Double.POSITIVE_INFINITY));
        deviations.set(2, 0.1);
        RigidMotion stated =
                new RigidMotion(new Vec3(8, 8, -2), Quat.IDENTITY, Vec3.ZERO, Vec3.ZERO);
        run.start(new KnownStart(stated, deviations));

        RigidMotion begins = LocalMotion.begun(run.build(), model).start().orElseThrow().motion();

        assertThat(begins.position().distance(new Vec3(0, 1, -2))).isLessThan(1e-9);
        assertThat(begins.velocity().distance(new Vec3(0.2, 0, 0))).isLessThan(1e-9);
        assertThat(begins.orientation()).isEqualTo(model.start().orientation());
    }
}
