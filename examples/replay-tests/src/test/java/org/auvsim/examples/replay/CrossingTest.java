package org.auvsim.examples.replay;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;
import static org.auvsim.junit.TrajectoryAssert.assertThatTrajectory;

import org.auvsim.junit.Replay;
import org.auvsim.junit.ReplayScenario;
import org.junit.jupiter.api.Test;

/** A scenario without clients needs no recording, but an end. */
class CrossingTest {
    /** Two spheres of 0.5 m, from (-1, 0) and (0, -1) at 2 m/s each toward the origin. */
    @Test
    @ReplayScenario(value = "../scenarios/crossing.xml", until = 1)
    void thePathsCross(Replay replay) {
        assertThatTrajectory(replay.trajectory("A")).collidesWith("B");
        assertThat(replay.collisions().getFirst().time())
                .isCloseTo((1 - Math.sqrt(0.5)) / 2, within(1e-9));
    }
}
