package org.auvsim.core.step;

import static org.assertj.core.api.Assertions.assertThat;

import org.auvsim.core.entity.WorldObjectDefinition;
import org.auvsim.core.math.Draws;
import org.auvsim.core.math.Vec3;
import org.auvsim.core.volume.Box;
import org.auvsim.core.volume.Capsule;
import org.auvsim.core.volume.Sphere;
import org.auvsim.core.volume.Volume;
import org.auvsim.core.world.World;
import org.auvsim.core.world.WorldBuilder;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

import java.util.stream.LongStream;

/** No contact adds energy, whatever the volumes, restitution and friction. */
class StepEnergyTest {
    static LongStream seeds() {
        return LongStream.rangeClosed(1, 20);
    }

    static LongStream manySeeds() {
        return LongStream.rangeClosed(1, 200);
    }

    private static Volume volume(Draws draws) {
        double kind = draws.number(0, 3);
        if (kind < 1) {
            return new Sphere(draws.number(0.2, 0.5));
        }
        return kind < 2
                ? new Box(draws.vector(0.3, 0.9))
                : new Capsule(draws.number(0.15, 0.3), draws.number(0.2, 0.6));
    }

    private static WorldObjectDefinition.Builder drawn(
            WorldObjectDefinition.Builder body, int i, Draws draws) {
        Vec3 velocity = draws.vector(2);
        Vec3 spin = draws.vector(1);
        return body.restitution(draws.number(-0.3, 1.3) < 0.5 ? 0 : draws.number(0, 1))
                .friction(draws.number(0, 1))
                .position(1.3 * (i % 3 - 1), 1.3 * (i / 3 % 3 - 1), 1 + 1.3 * Math.floorDiv(i, 9))
                .orientation(draws.orientation())
                .velocity(velocity.x(), velocity.y(), velocity.z())
                .angularVelocity(spin.x(), spin.y(), spin.z());
    }

    /** Where {@link #drawn} puts body i, on its way to the middle of all. */
    private static WorldObjectDefinition.Builder towardsTheMiddle(
            WorldObjectDefinition.Builder body, int i, Draws draws) {
        double speed = draws.number(-2, -1);
        return body.velocity(
                speed * (i % 3 - 1),
                speed * (Math.floorDiv(i, 3) % 3 - 1),
                speed * (Math.floorDiv(i, 9) - 0.5));
    }

    @ParameterizedTest(name = "seed {0}")
    @MethodSource("seeds")
    void inARoomUnderGravityEnergyOnlyFalls(long seed) {
        Draws draws = new Draws(seed);
        WorldBuilder builder = World.builder().stepper(EventStepper.standard());
        Ground.room(5, draws.number(0, 1)).forEach(builder::add);
        for (int i = 0; i < 12; i++) {
            builder.add(drawn(Ground.heavy("Body " + i, volume(draws)), i, draws).build());
        }
        World world = builder.build();
        double start = Ground.energy(world);
        double energy = start;

        while (world.time() < 4) {
            world.advanceTimestep();
            double now = Ground.energy(world);
            assertThat(now - energy)
                    .as("gain (J) up to %s s", world.time())
                    .isLessThan(1e-5 * start);
            energy = now;
        }

        assertThat(energy).isLessThan(start);
    }

    @ParameterizedTest(name = "seed {0}")
    @MethodSource("seeds")
    void inTheVoidEnergyOnlyFallsAndMomentumStays(long seed) {
        Draws draws = new Draws(seed);
        WorldBuilder builder = World.builder().stepper(EventStepper.standard());
        for (int i = 0; i < 18; i++) {
            WorldObjectDefinition.Builder body =
                    WorldObjectDefinition.named("Body " + i)
                            .volume(volume(draws))
                            .mass(draws.number(0.5, 2));
            builder.add(towardsTheMiddle(drawn(body, i, draws), i, draws).build());
        }
        World world = builder.build();
        Vec3 momentum = momentum(world);
        double start = Ground.kineticEnergy(world);
        double energy = start;

        while (world.time() < 3) {
            world.advanceTimestep();
            double now = Ground.kineticEnergy(world);
            assertThat(now - energy)
                    .as("gain (J) up to %s s", world.time())
                    .isLessThan(1e-6 * start);
            energy = now;
        }

        assertThat(world.statistics().collisions()).isPositive();
        assertThat(momentum(world).distance(momentum)).isLessThan(1e-11);
    }

    /** What stands on one end, tumbles or rolls to rest is held for many frames. */
    @ParameterizedTest(name = "seed {0}")
    @MethodSource("manySeeds")
    void oneBodyThatFallsOnAFloorGainsNothing(long seed) {
        Draws draws = new Draws(seed);
        World world =
                World.builder()
                        .stepper(EventStepper.standard())
                        .add(Ground.floor(draws.number(0, 1)))
                        .add(drawn(Ground.heavy("Body", volume(draws)), 4, draws).build())
                        .build();
        double start = Ground.energy(world);
        double energy = start;

        while (world.time() < 4) {
            world.advanceTimestep();
            double now = Ground.energy(world);
            assertThat(now - energy)
                    .as("gain (J) up to %s s", world.time())
                    .isLessThan(1e-5 * start);
            energy = now;
        }

        StepStatistics met = world.statistics();
        assertThat(met.collisions() + met.heldPairs()).isPositive();
    }

    private static Vec3 momentum(World world) {
        return world.objects().stream().map(o -> o.linearMomentum()).reduce(Vec3.ZERO, Vec3::plus);
    }
}
