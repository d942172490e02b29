package org.auvsim.core.step;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.auvsim.core.reference.Swarm;
import org.auvsim.core.world.World;
import org.auvsim.core.world.WorldEvent;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import java.util.stream.LongStream;

/**
 * Crowds of 10 to 40 balls on springs: the event stepper meets every collision of the exact
 * solution, grazes included, and no two balls ever overlap.
 */
class SwarmCollisionsTest {
    private static final double END = 1;

    static LongStream seeds() {
        return LongStream.rangeClosed(1, 20);
    }

    @ParameterizedTest(name = "seed {0}")
    @MethodSource("seeds")
    void everyCollisionIsMetAndNothingOverlaps(long seed) {
        SplittableRandom random = new SplittableRandom(seed);
        SpringSwarm swarm = new SpringSwarm(100 + seed, random.nextInt(10, 41));
        List<Swarm.Meeting> exact = swarm.meetings(END, 1e-9);
        World world = swarm.world(EventStepper.standard(), 0.05);
        List<Swarm.Meeting> met = new ArrayList<>();
        world.addListener(
                event -> {
                    if (event instanceof WorldEvent.Collided(double _, Collision collision)) {
                        met.add(SpringSwarm.meeting(collision));
                    }
                });
        while (world.time() < 2 * END) {
            world.advanceTimestep(random.nextDouble(0.003, 0.006));
            assertThat(swarm.overlap(world))
                    .as("overlap at %s s (radii)", world.time())
                    .isLessThan(1e-9);
        }

        assertThat(met).hasSizeGreaterThan(exact.size());
        for (int k = 0; k < exact.size(); k++) {
            Swarm.Meeting wanted = exact.get(k);
            Swarm.Meeting got = met.get(k);
            assertThat(got.first() + " and " + got.second())
                    .as("collision %d of %d", k + 1, exact.size())
                    .isEqualTo(wanted.first() + " and " + wanted.second());
            assertThat(got.time()).as("%s", wanted).isEqualTo(wanted.time(), within(1e-7));
        }
    }
}
