package org.auvsim.examples.replay;

import static org.auvsim.junit.TrajectoryAssert.assertThatTrajectory;

import org.auvsim.core.math.Vec3;
import org.auvsim.junit.Region;
import org.auvsim.junit.Replay;
import org.auvsim.junit.ReplayScenario;
import org.auvsim.junit.Trajectory;
import org.junit.jupiter.api.Test;

/**
 * A minute of a torpedo that examples/clients/autopilot.py steers through a current: the
 * autopilot's commands come from the recording, what they do is simulated anew.
 */
@ReplayScenario("leg.auvsml.gz")
class LegTest {
    private static final Vec3 WAYPOINT = new Vec3(60, 0, -20);

    @Test
    void theWaypointIsReached(Replay replay) {
        assertThatTrajectory(replay.trajectory("REMUS 100")).passesNear(WAYPOINT, 4);
    }

    @Test
    void theVehicleStaysInItsDepths(Replay replay) {
        double anywhere = Double.POSITIVE_INFINITY;
        Region depths =
                Region.box(new Vec3(-anywhere, -anywhere, -28), new Vec3(anywhere, anywhere, -12));

        assertThatTrajectory(replay.trajectory("REMUS 100"))
                .staysWithin(depths)
                .staysSlowerThan(2.5)
                .collidesWithNothing();
    }

    @Test
    void theModelIsStillWhatItWasWhenThisWasRecorded(Replay replay) {
        Trajectory remus = replay.trajectory("REMUS 100");

        assertThatTrajectory(remus).matchesRecording(0.05, 0.05);
    }
}
