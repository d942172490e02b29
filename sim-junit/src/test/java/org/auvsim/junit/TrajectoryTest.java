package org.auvsim.junit;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import org.auvsim.core.math.Mat3;
import org.auvsim.core.math.Quat;
import org.auvsim.core.math.Vec3;
import org.junit.jupiter.api.Test;

@ReplayScenario(value = "drift.xml", until = 6)
class TrajectoryTest {
    private static final double ROUNDING = 1e-9;

    @Test
    void hasTheBeginningAndEachStep(Replay replay) {
        Trajectory escort = replay.trajectory(2);

        assertThat(escort.samples()).hasSize(121);
        assertThat(escort.first().time()).isZero();
        assertThat(escort.last().time()).isCloseTo(6, within(ROUNDING));
        assertThat(escort.last().velocity().x()).isCloseTo(1, within(ROUNDING));
        assertThat(escort.last().angularVelocity().z()).isCloseTo(0.5, within(ROUNDING));
        assertThat(replay.trajectory("Rock").samples()).hasSize(2);
    }

    /** Uniform motion is linear in time; so is a turn about one axis, but for the chord. */
    @Test
    void isInterpolatedBetweenSteps(Replay replay) {
        Sample between = replay.trajectory("Escort").at(3.0125);

        assertThat(between.time()).isEqualTo(3.0125);
        assertThat(between.position().x()).isCloseTo(3.0125, within(ROUNDING));
        Quat turned = Quat.ofAxisAngle(new Vec3(0, 0, 1), 0.5 * 3.0125);
        assertThat(new Pose(0, Vec3.ZERO, turned.toMatrix()).angle(between.orientation()))
                .isCloseTo(0, within(1e-6));
    }

    @Test
    void isNowhereBeforeAndAfter(Replay replay) {
        assertThatThrownBy(() -> replay.trajectory("AUV").at(6.1))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining("'AUV' was in the world from 0.0 to ")
                .hasMessageEndingWith("not at 6.1 s");
    }

    @Test
    void isNearestToWhatStandsStillWhicheverOfTheTwoIsAsked(Replay replay) {
        Trajectory auv = replay.trajectory("AUV");
        Trajectory buoy = replay.trajectory("Buoy");

        assertThat(auv.nearestTo(buoy)).isEqualTo(buoy.nearestTo(auv));
        Approach nearest = buoy.nearestTo(auv).orElseThrow();
        assertThat(nearest.time()).isCloseTo(2, within(ROUNDING));
        assertThat(nearest.distance()).isCloseTo(3, within(ROUNDING));
    }

    @Test
    void aTurnHasItsAngle() {
        Pose straight = new Pose(0, Vec3.ZERO, Mat3.IDENTITY);
        Vec3 axis = new Vec3(1, -2, 2);

        assertThat(straight.angle(Quat.ofAxisAngle(axis, 1e-6))).isCloseTo(1e-6, within(1e-15));
        assertThat(straight.angle(Quat.ofAxisAngle(axis, -2))).isCloseTo(2, within(1e-12));
        assertThat(straight.angle(Quat.ofAxisAngle(axis, Math.PI)))
                .isCloseTo(Math.PI, within(1e-6));
    }

    @Test
    void theReplayTellsOfItself(Replay replay) {
        assertThat(replay.duration()).isCloseTo(6, within(ROUNDING));
        assertThat(replay.scenario().worldObject()).hasSize(4);
        assertThat(replay.trajectories()).map(Trajectory::name).startsWith("AUV", "Escort");
        assertThat(replay.divergence()).isEmpty();
        assertThat(replay.collisions()).hasSize(1);
        Encounter bounce = replay.collisions().getFirst();
        assertThat(bounce.time()).isCloseTo(4, within(1e-6));
        assertThat(bounce.impulse().norm()).isCloseTo(4, within(1e-6));
    }
}
