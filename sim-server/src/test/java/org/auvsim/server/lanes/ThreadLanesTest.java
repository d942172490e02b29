package org.auvsim.server.lanes;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import org.auvsim.core.effect.CentralForce;
import org.auvsim.core.entity.WorldObjectDefinition;
import org.auvsim.core.math.Vec3;
import org.auvsim.core.step.Lanes;
import org.auvsim.core.volume.Sphere;
import org.auvsim.core.world.World;
import org.auvsim.core.world.WorldBuilder;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import java.util.SplittableRandom;

@Timeout(60)
class ThreadLanesTest {
    private static final int BODIES = 3_000;

    @Test
    void eachPartRunsOnceARunAndWhatItWroteIsSeen() {
        try (ThreadLanes lanes = new ThreadLanes(3)) {
            int[] runs = new int[3];
            for (int k = 1; k <= 20_000; k++) {
                lanes.run(lane -> runs[lane]++);
                assertThat(runs).containsExactly(k, k, k);
            }
        }
    }

    @ParameterizedTest(name = "in part {0}")
    @ValueSource(ints = {0, 1, 2})
    void whatAPartThrowsReachesTheCallerAndTheLanesGoOn(int faulty) {
        try (ThreadLanes lanes = new ThreadLanes(3)) {
            int[] runs = new int[3];
            assertThatThrownBy(
                            () ->
                                    lanes.run(
                                            lane -> {
                                                runs[lane]++;
                                                if (lane == faulty) {
                                                    throw new IllegalStateException("part " + lane);
                                                }
                                            }))
                    .isInstanceOf(IllegalStateException.class)
                    .hasMessage("part " + faulty);
            assertThat(runs).containsExactly(1, 1, 1);

            lanes.run(lane -> runs[lane]++);
            assertThat(runs).containsExactly(2, 2, 2);
        }
    }

    @Test
    void closedLanesRunNothing() {
        ThreadLanes lanes = new ThreadLanes(2);
        lanes.close();

        assertThatThrownBy(() -> lanes.run(_ -> {})).isInstanceOf(IllegalStateException.class);
    }

    @Test
    void thereIsAtLeastOneLane() {
        assertThatThrownBy(() -> new ThreadLanes(0))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessage("the number of lanes must be 1 to 256, but is 0");
    }

    @Test
    void aStepIsTheSameToTheBitForAnyNumberOfLanes() {
        long alone = hash(Lanes.ONE);
        for (int count = 1; count <= 3; count++) {
            try (ThreadLanes lanes = new ThreadLanes(count)) {
                assertThat(hash(lanes)).as("%d lanes", count).isEqualTo(alone);
            }
        }
    }

    /** A cloud of spheres that falls together. */
    private static long hash(Lanes lanes) {
        SplittableRandom random = new SplittableRandom(4);
        WorldBuilder builder = World.builder().lanes(lanes).allowOverlaps();
        for (int i = 0; i < BODIES; i++) {
            builder.add(
                    WorldObjectDefinition.named("Sphere " + i)
                            .mass(1)
                            .volume(new Sphere(0.5))
                            .position(3 * (i % 15), 3 * (i / 15 % 15), 3 * (i / 225))
                            .velocity(
                                    random.nextDouble(-9, 9),
                                    random.nextDouble(-9, 9),
                                    random.nextDouble(-9, 9))
                            .effect(new CentralForce(5, 0.1, new Vec3(20, 20, 20)))
                            .build());
        }
        World world = builder.build();
        for (int step = 0; step < 5; step++) {
            world.advanceTimestep();
        }
        assertThat(world.statistics().collisions()).isPositive();
        return world.stateHash();
    }
}
