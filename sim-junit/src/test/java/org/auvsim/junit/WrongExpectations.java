package org.auvsim.junit;

import static org.auvsim.junit.TrajectoryAssert.assertThatTrajectory;

import org.auvsim.core.math.Vec3;
import org.junit.jupiter.api.Test;

/** Tests that fail, each by one assertion; run inside of {@link TrajectoryAssertTest} alone. */
@ReplayScenario(value = "drift.xml", until = 6)
class WrongExpectations {
    @Test
    void box(Replay replay) {
        assertThatTrajectory(replay.trajectory("AUV"))
                .staysWithin(Region.box(new Vec3(-1, -1, -3), new Vec3(3.52, 1, 0)));
    }

    @Test
    void ball(Replay replay) {
        assertThatTrajectory(replay.trajectory("AUV")).staysWithin(2.52, new Vec3(0, 0, -2));
    }

    @Test
    void escort(Replay replay) {
        assertThatTrajectory(replay.trajectory("AUV")).staysWithin(3, replay.trajectory("Escort"));
    }

    @Test
    void clear(Replay replay) {
        assertThatTrajectory(replay.trajectory("Rock")).staysClearOf(replay.trajectory("AUV"), 1.2);
    }

    @Test
    void pass(Replay replay) {
        assertThatTrajectory(replay.trajectory("AUV")).passesNear(new Vec3(2, 1, -2), 0.5);
    }

    @Test
    void end(Replay replay) {
        assertThatTrajectory(replay.trajectory("AUV")).endsNear(new Vec3(0, 0, -2), 0.5);
    }

    @Test
    void speed(Replay replay) {
        assertThatTrajectory(replay.trajectory("Escort")).staysSlowerThan(0.9);
    }

    @Test
    void meeting(Replay replay) {
        assertThatTrajectory(replay.trajectory("AUV")).collidesWith("Buoy");
    }

    @Test
    void nothing(Replay replay) {
        assertThatTrajectory(replay.trajectory("AUV")).collidesWithNothing();
    }

    @Test
    void recording(Replay replay) {
        assertThatTrajectory(replay.trajectory("AUV")).matchesRecording(1);
    }

    @Test
    void name(Replay replay) {
        assertThatTrajectory(replay.trajectory("Submarine")).collidesWithNothing();
    }

    @Test
    void tolerance(Replay replay) {
        assertThatTrajectory(replay.trajectory("AUV")).endsNear(Vec3.ZERO, -1);
    }
}
