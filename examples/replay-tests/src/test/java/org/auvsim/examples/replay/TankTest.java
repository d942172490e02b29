package org.auvsim.examples.replay;

import static org.assertj.core.api.Assertions.assertThat;
import static org.auvsim.junit.TrajectoryAssert.assertThatTrajectory;

import org.auvsim.core.math.Vec3;
import org.auvsim.junit.Region;
import org.auvsim.junit.Replay;
import org.auvsim.junit.ReplayScenario;
import org.auvsim.junit.Trajectory;
import org.junit.jupiter.api.Test;

/**
 * Ten seconds in the test tank with examples/python/robot.py, which corrects its simulated self.
 */
@ReplayScenario("tank.auvsml.gz")
class TankTest {
    private static final Region TANK = Region.box(new Vec3(-10, -5, -5), new Vec3(10, 5, 0));

    @Test
    void nothingGetsOutOfTheTank(Replay replay) {
        for (Trajectory body : replay.trajectories()) {
            if (!body.name().endsWith("Wall") && !body.name().matches("Floor|Cover")) {
                assertThatTrajectory(body).staysWithin(TANK);
            }
        }
    }

    @Test
    void theVehicleTouchesNothing(Replay replay) {
        Trajectory auv = replay.trajectory("AUV-1701");

        assertThatTrajectory(auv)
                .collidesWithNothing()
                .staysClearOf(replay.trajectory("Crate"), 3)
                .staysSlowerThan(0.6);
    }

    /** Its thrusters push it ahead; its corrections, 5 mm each, move it to the left. */
    @Test
    void feedbackBringsTheVehicleWhereTheRobotWas(Replay replay) {
        assertThatTrajectory(replay.trajectory("AUV-1701"))
                .endsNear(new Vec3(-2.06, 0.88, -2), 0.05);
    }

    @Test
    void theBallsMeet(Replay replay) {
        assertThatTrajectory(replay.trajectory("Green Ball"))
                .collidesWith("Blue Ball")
                .collidesWith("Cover");
        assertThat(replay.collisions()).hasSize(6);
    }

    @Test
    void allGoesAsItWentWhenItWasRecorded(Replay replay) {
        assertThat(replay.trajectories())
                .allSatisfy(body -> assertThatTrajectory(body).matchesRecording(0.01, 0.01));
    }
}
