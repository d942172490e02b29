package org.auvsim.core.step;

import static org.assertj.core.api.Assertions.assertThat;

import org.auvsim.core.effect.Gravity;
import org.auvsim.core.entity.WorldObjectDefinition;
import org.auvsim.core.math.Draws;
import org.auvsim.core.math.Vec3;
import org.auvsim.core.volume.Box;
import org.auvsim.core.volume.HalfSpace;
import org.auvsim.core.volume.Sphere;
import org.auvsim.core.volume.Volume;
import org.auvsim.core.world.World;
import org.auvsim.core.world.WorldBuilder;
import org.auvsim.core.world.WorldEvent;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.IntConsumer;

/** Equal worlds stay equal to the bit: run twice, copied on the way, on any number of lanes. */
class DeterminismTest {
    private static final int STEPS = 60;

    /** Plain threads, one a part, started anew for each run; it counts the runs. */
    private record Threads(int count, AtomicInteger runs) implements Lanes {
        Threads(int count) {
            this(count, new AtomicInteger());
        }

        @Override
        public void run(IntConsumer part) {
            runs.incrementAndGet();
            List<Thread> threads = new ArrayList<>();
            for (int i = 0; i < count; i++) {
                int number = i;
                threads.add(Thread.ofPlatform().start(() -> part.accept(number)));
            }
            try {
                for (Thread thread : threads) {
                    thread.join();
                }
            } catch (InterruptedException e) {
                throw new IllegalStateException(e);
            }
        }
    }

    /** Balls and boxes that rain on the ground and lie there, with restitution and friction. */
    private static WorldBuilder rain(long seed, int n) {
        Draws draws = new Draws(seed);
        WorldBuilder world =
                World.builder()
                        .stepper(EventStepper.standard())
                        .add(
                                WorldObjectDefinition.named("Ground")
                                        .volume(new HalfSpace())
                                        .fixed()
                                        .friction(0.5)
                                        .build());
        for (int i = 0; i < n; i++) {
            Volume volume =
                    i % 3 == 0
                            ? new Box(draws.vector(0.4, 0.8))
                            : new Sphere(draws.number(0.2, 0.4));
            world.add(
                    WorldObjectDefinition.named("Body " + i)
                            .volume(volume)
                            .mass(draws.number(0.5, 2))
                            .restitution(draws.number(0, 1))
                            .friction(draws.number(0, 1))
                            .position(
                                    1.2 * (i % 5),
                                    1.2 * (i / 5 % 5),
                                    0.8 + 1.2 * Math.floorDiv(i, 25))
                            .orientation(draws.orientation())
                            .velocity(draws.number(-1, 1), draws.number(-1, 1), -1)
                            .effect(new Gravity(9.81))
                            .build());
        }
        return world;
    }

    /** Balls in the void that fly at each other. */
    private static WorldBuilder cloud(long seed, int n) {
        Draws draws = new Draws(seed);
        WorldBuilder world = World.builder().stepper(EventStepper.standard());
        int side = (int) Math.ceil(Math.cbrt(n));
        for (int i = 0; i < n; i++) {
            Vec3 cell =
                    new Vec3(
                            i % side, Math.floorDiv(i, side) % side, Math.floorDiv(i, side * side));
            Vec3 velocity = draws.vector(3);
            world.add(
                    Scene.ball("Ball " + i, draws.number(0.2, 0.4))
                            .position(cell.plus(draws.vector(0.05)))
                            .velocity(velocity.x(), velocity.y(), velocity.z())
                            .build());
        }
        return world;
    }

    /**
     * Balls that fly at each other, most of them on springs to the ball before: chains of up to
     * 300, some of them on a fixed ball.
     */
    private static WorldBuilder chains(long seed, int n) {
        Draws draws = new Draws(seed);
        WorldBuilder world = World.builder().stepper(EventStepper.standard());
        int left = 0;
        for (int i = 0; i < n; i++) {
            boolean begins = left-- == 0;
            left = begins ? (int) draws.number(0, i % 2 == 0 ? 150 : 3) : left;
            Vec3 velocity = draws.vector(3);
            WorldObjectDefinition.Builder ball =
                    Scene.ball("Ball " + i, draws.number(0.2, 0.4))
                            .id(i + 1)
                            .position(
                                    new Vec3(i % 9, Math.floorDiv(i, 9) % 9, Math.floorDiv(i, 81)));
            if (begins && i % 3 == 0) {
                ball.fixed();
            } else {
                ball.velocity(velocity.x(), velocity.y(), velocity.z());
            }
            world.add((begins ? ball : ball.effect(new PairSpring(i, 40, 1))).build());
        }
        return world;
    }

    private static World run(World world, int steps) {
        for (int i = 0; i < steps; i++) {
            world.advanceTimestep();
        }
        return world;
    }

    @ParameterizedTest(name = "{0} lanes, seed {1}")
    @CsvSource({"2, 1", "8, 1", "2, 2", "8, 2"})
    void theNumberOfLanesChangesNoBit(int lanes, long seed) {
        World one = run(cloud(seed, 2500).build(), 6);

        assertSameOnLanes(lanes, cloud(seed, 2500), 6, one);
    }

    @ParameterizedTest(name = "{0} lanes")
    @ValueSource(ints = {2, 8})
    void theNumberOfLanesChangesNoBitOfAPile(int lanes) {
        World one = run(rain(3, 520).build(), 10);

        assertThat(one.statistics().heldPairs()).isPositive();
        assertSameOnLanes(lanes, rain(3, 520), 10, one);
    }

    @ParameterizedTest(name = "{0} lanes, seed {1}")
    @CsvSource({"1, 9", "2, 9", "8, 9", "2, 10", "8, 10"})
    void theNumberOfLanesChangesNoBitOfCoupledBodies(int lanes, long seed) {
        World one = run(chains(seed, 600).build(), 2);

        assertThat(one.statistics().collisions()).isPositive();
        assertSameOnLanes(lanes, chains(seed, 600), 2, one);
    }

    /** The world is large enough for lanes to pay: they must have been run in each step. */
    private static void assertSameOnLanes(int lanes, WorldBuilder world, int steps, World one) {
        Threads threads = new Threads(lanes);

        long hash = run(world.lanes(threads).build(), steps).stateHash();

        assertThat(hash).isEqualTo(one.stateHash());
        assertThat(threads.runs()).hasValueGreaterThanOrEqualTo(steps);
    }

    @ParameterizedTest(name = "seed {0}")
    @ValueSource(longs = {4, 5, 6})
    void aListenerChangesNoBit(long seed) {
        World unheard = run(rain(seed, 20).build(), STEPS);
        World heard = rain(seed, 20).build();
        int[] collisions = {0};
        heard.addListener(e -> collisions[0] += e instanceof WorldEvent.Collided ? 1 : 0);
        run(heard, STEPS);

        assertThat(collisions[0]).isPositive();
        assertThat(heard.stateHash()).isEqualTo(unheard.stateHash());
    }

    /** Copies in the air, at the first impacts, and when all lie. */
    @ParameterizedTest(name = "after {0} steps, seed {1}")
    @CsvSource({"3, 7", "9, 7", "15, 7", "40, 7", "120, 7", "15, 8", "120, 8"})
    void aCopyGoesOnAsTheOriginal(int steps, long seed) {
        World original = run(rain(seed, 15).build(), steps);
        World copy = original.copy();

        for (int i = 0; i < 40; i++) {
            original.advanceTimestep();
            copy.advanceTimestep();
            assertThat(copy.stateHash())
                    .as("step %d after the copy", i + 1)
                    .isEqualTo(original.stateHash());
        }
    }
}
