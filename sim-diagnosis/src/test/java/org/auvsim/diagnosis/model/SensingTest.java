package org.auvsim.diagnosis.model;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.auvsim.core.entity.Frame;
import org.auvsim.core.math.Quat;
import org.auvsim.core.math.Vec3;
import org.auvsim.diagnosis.run.Channel;
import org.auvsim.diagnosis.run.MeasuredRun;
import org.auvsim.diagnosis.run.MeasuredRunBuilder;
import org.auvsim.server.feedback.RigidMotion;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

import java.util.function.Consumer;

class SensingTest {
    private static final Vec3 UP = new Vec3(0, 0, 1);
    private static final int SAMPLES = 60;

    /** Round a circle of 2 m at 0.7 rad/s, climbing, while it turns faster and faster. */
    private static RigidMotion motion(double t) {
        double a = 0.7 * t;
        double angle = 0.3 * t + 0.1 * t * t;
        return new RigidMotion(
                new Vec3(2 * Math.cos(a), 2 * Math.sin(a), 0.5 * t),
                Quat.ofAxisAngle(UP, angle),
                new Vec3(-1.4 * Math.sin(a), 1.4 * Math.cos(a), 0.5),
                UP.times(0.3 + 0.2 * t));
    }

    private static MeasuredRun run() {
        return run(Frame.WORLD).build();
    }

    /** With velocities in axes. */
    private static MeasuredRunBuilder run(Frame velocities) {
        MeasuredRunBuilder run = MeasuredRun.named("run").frame(Channel.VELOCITY, velocities);
        for (int k = 0; k < SAMPLES; k++) {
            run.at(5 + 0.1 * k);
        }
        return run;
    }

    private static RigidMotion[] told(Sensing sensing, int from) {
        MeasuredRun run = run();
        RigidMotion[] motions = new RigidMotion[SAMPLES - from];
        for (int k = 0; k < motions.length; k++) {
            motions[k] = motion(run.time(from + k) - 5);
        }
        return sensing.of(motions, run, from, motions.length);
    }

    private static void assertNear(RigidMotion actual, RigidMotion expected, double error) {
        for (double difference : actual.minus(expected)) {
            assertThat(Math.abs(difference)).isLessThan(error);
        }
    }

    @Test
    void placesAndOrientationsMayBeOlderThanAllElse() {
        Sensing late = Sensing.EXACT.delayed(0.05).withLatePositions(0.1).withLateOrientations(0.2);

        assertThat(late.age(Channel.POSITION)).isCloseTo(0.15, within(1e-12));
        assertThat(late.age(Channel.ORIENTATION)).isEqualTo(0.25);
        assertThat(late.age(Channel.VELOCITY)).isEqualTo(0.05);
        assertThat(late.age(Channel.ANGULAR_VELOCITY)).isEqualTo(0.05);
        assertThat(late.isPrompt()).isFalse();
        assertThat(Sensing.EXACT.withLatePositions(0.1).isPrompt()).isFalse();
        assertThat(Sensing.EXACT.withLateOrientations(0.1).isPrompt()).isFalse();
        assertThat(Sensing.EXACT.isPrompt()).isTrue();
    }

    /** What is old is what was; before the first sample and after the last it went on evenly. */
    @ParameterizedTest
    @ValueSource(doubles = {0.1, 0.23, 0.6, -0.37})
    void aDelayTellsTheMotionOfBefore(double delay) {
        RigidMotion[] told = told(Sensing.EXACT.delayed(delay), 10);
        for (int k = 0; k < told.length; k++) {
            double then = 0.1 * (k + 10) - delay;
            double nearest = Math.max(1, Math.min(5.9, then));
            RigidMotion expected = evenly(motion(nearest), then - nearest);
            assertNear(told[k], expected, 2e-4);
        }
    }

    private static RigidMotion evenly(RigidMotion motion, double span) {
        return new RigidMotion(
                motion.position().plus(motion.velocity().times(span)),
                Quat.ofAxisAngle(UP, motion.angularVelocity().z() * span)
                        .times(motion.orientation()),
                motion.velocity(),
                motion.angularVelocity());
    }

    /** As iron that turns with the body pulls it; gyroscopes and receivers do not mind. */
    @Test
    void aCompassBesideIronIsOffByAnotherAngleOnEachHeading() {
        RigidMotion[] told = told(Sensing.EXACT.besideIron(0.3, -0.1), 0);

        for (int k = 0; k < told.length; k++) {
            double t = 0.1 * k;
            double heading = 0.3 * t + 0.1 * t * t;
            double off = 0.3 * Math.sin(heading) - 0.1 * Math.cos(heading);
            RigidMotion then = motion(t);
            assertNear(
                    told[k],
                    new RigidMotion(
                            then.position(),
                            Quat.ofAxisAngle(UP, heading + off),
                            then.velocity(),
                            then.angularVelocity()),
                    1e-9);
        }
    }

    @Test
    void aBodyThatPointsUprightHasNoHeadingAndItsCompassNoDeviation() {
        Quat upright = new Quat(0.5, 0.5, -0.5, 0.5);

        assertThat(new CompassDeviation(0.3, 0.2).of(upright)).isZero();
    }

    /** A receiver's fixes are old, while all else is told at once; the delays of both add up. */
    @ParameterizedTest
    @CsvSource({"0, 0.23", "0.1, 0.37"})
    void positionsMayBeOlder(double delay, double older) {
        RigidMotion[] told = told(Sensing.EXACT.delayed(delay).withLatePositions(older), 10);

        RigidMotion before = motion(2.5 - delay - older);
        RigidMotion then = motion(2.5 - delay);
        assertNear(
                told[15],
                new RigidMotion(
                        before.position(),
                        then.orientation(),
                        then.velocity(),
                        then.angularVelocity()),
                2e-4);
    }

    /** A compass is slow, while all else is told at once. */
    @ParameterizedTest
    @CsvSource({"0, 0.23", "0.1, 0.37"})
    void orientationsMayBeOlder(double delay, double older) {
        RigidMotion[] told = told(Sensing.EXACT.delayed(delay).withLateOrientations(older), 10);

        RigidMotion then = motion(2.5 - delay);
        assertNear(
                told[15],
                new RigidMotion(
                        then.position(),
                        motion(2.5 - delay - older).orientation(),
                        then.velocity(),
                        then.angularVelocity()),
                2e-4);
    }

    /** A leg of one sample has no other that it could lie between. */
    @Test
    void aSingleSampleGoesOnAsItIs() {
        RigidMotion[] told = told(Sensing.EXACT.delayed(-0.1), SAMPLES - 1);

        RigidMotion last = motion(0.1 * (SAMPLES - 1));
        assertThat(told).hasSize(1);
        assertThat(told[0].position().distance(last.position().plus(last.velocity().times(0.1))))
                .isLessThan(1e-12);
        assertThat(told[0].velocity()).isEqualTo(last.velocity());
    }

    @Test
    void scaleTurnYawOffsetAndDriftAreOfTheRunsTime() {
        Sensing sensing =
                Sensing.EXACT
                        .scaled(new Vec3(0.1, 0, -0.2))
                        .turned(UP.times(0.4))
                        .yawed(0.2, 0.01)
                        .shifted(new Vec3(0, 0.5, -0.1))
                        .drifting(new Vec3(0.03, 0, 0));
        RigidMotion told = told(sensing, 20)[5];
        RigidMotion moved = motion(2.5);
        Quat axes = Quat.ofAxisAngle(UP, 0.4);
        Vec3 p = moved.position();
        Vec3 v = moved.velocity();
        RigidMotion expected =
                new RigidMotion(
                        axes.rotate(new Vec3(1.1 * p.x(), p.y(), 0.8 * p.z()))
                                .plus(new Vec3(0.03 * 2.5, 0.5, -0.1)),
                        Quat.ofAxisAngle(UP, 0.4 + 0.2 + 0.025).times(moved.orientation()),
                        axes.rotate(new Vec3(1.1 * v.x(), v.y(), 0.8 * v.z()))
                                .plus(new Vec3(0.03, 0, 0)),
                        axes.rotate(moved.angularVelocity()));
        assertNear(told, expected, 1e-12);
    }

    /** An antenna goes round the body's origin as that turns; what it is told of is scaled. */
    @Test
    void aLeverArmTurnsWithTheBody() {
        Sensing sensing = Sensing.EXACT.armed(new Vec3(0.5, -0.2, 0.3)).scaled(new Vec3(0.1, 0, 0));

        RigidMotion told = told(sensing, 20)[5];

        RigidMotion moved = motion(2.5);
        double angle = 0.3 * 2.5 + 0.1 * 2.5 * 2.5;
        double ahead = 0.5 * Math.cos(angle) + 0.2 * Math.sin(angle);
        double aside = 0.5 * Math.sin(angle) - 0.2 * Math.cos(angle);
        Vec3 expected =
                new Vec3(
                        1.1 * (moved.position().x() + ahead),
                        moved.position().y() + aside,
                        moved.position().z() + 0.3);
        assertThat(told.position()).satisfies(near(expected));
        assertThat(told.orientation()).isEqualTo(moved.orientation());
    }

    /** Sensors know nothing of where a run is cut. */
    @Test
    void inAPartDriftsGoOnAsInTheWholeRun() {
        Sensing sensing = Sensing.EXACT.yawed(0.2, 0.01).drifting(new Vec3(0.03, 0, -0.02));
        MeasuredRun part = run().part("later", 10, 50).part("latest", 10, 40);
        RigidMotion[] moved = {motion(2.5)};

        RigidMotion told = sensing.of(moved, part, 5, 1)[0];

        assertNear(told, sensing.of(moved, run(), 25, 1)[0], 1e-12);
        assertThat(told.position().x() - moved[0].position().x()).isCloseTo(0.075, within(1e-12));
    }

    @Test
    void ofAMotionThatIsLostNothingIsTold() {
        RigidMotion[] lost = {Ensemble.LOST, Ensemble.LOST, Ensemble.LOST};

        RigidMotion[] told = Sensing.EXACT.delayed(0.1).yawed(0.1, 0).of(lost, run(), 0, 3);

        assertThat(told).containsOnly(Ensemble.LOST);
    }

    /** A compass that is off does not turn what a Doppler log and a gyro tell of the body. */
    @Test
    void velocitiesInAxesOfTheBodyAreThoseOfTheBody() {
        MeasuredRun run = run(Frame.BODY).frame(Channel.ANGULAR_VELOCITY, Frame.BODY).build();
        Sensing sensing =
                Sensing.EXACT
                        .scaled(new Vec3(0.1, 0, 0))
                        .turned(new Vec3(0.1, 0.2, 0.4))
                        .yawed(0.3, 0.01)
                        .drifting(new Vec3(0.03, 0, 0));
        RigidMotion moved = motion(2.5);

        RigidMotion told = sensing.of(new RigidMotion[] {moved}, run, 25, 1)[0];

        assertThat(told.orientation().rotateInverse(told.velocity()))
                .satisfies(near(moved.orientation().rotateInverse(moved.velocity())));
        assertThat(told.orientation().rotateInverse(told.angularVelocity()))
                .satisfies(near(moved.orientation().rotateInverse(moved.angularVelocity())));
    }

    private static Consumer<Vec3> near(Vec3 expected) {
        return actual -> assertThat(actual.distance(expected)).isLessThan(1e-12);
    }

    @Test
    void nothingIsTheMotionItself() {
        assertThat(told(Sensing.EXACT, 0)[7]).isEqualTo(motion(run().time(7) - 5));
    }
}
