package org.auvsim.examples.scala;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.auvsim.core.world.World;
import org.junit.jupiter.api.Test;

class BungeeTest {
    /** m x'' = -k x - c x' from rest at 1 m, with m = 2, k = 8 and c = 0.8: underdamped. */
    private static double closedSolution(double t) {
        double decay = 0.8 / (2 * 2);
        double omega = Math.sqrt(8.0 / 2 - decay * decay);
        return Math.exp(-decay * t) * (Math.cos(omega * t) + decay / omega * Math.sin(omega * t));
    }

    @Test
    void theBuoyMovesAsTheClosedSolution() throws Exception {
        World world = BungeeScenario.scenario().world();
        double furthest = 0;
        while (world.time() < 10) {
            world.advanceTimestep();
            double x = world.object(1).position().x();
            assertThat(x).isCloseTo(closedSolution(world.time()), within(2e-7));
            furthest = Math.max(furthest, -x);
        }
        assertThat(furthest).isGreaterThan(0.5);
    }
}
