package org.auvsim.core.step;

import static org.assertj.core.api.Assertions.assertThat;

import org.auvsim.core.effect.CentralForce;
import org.auvsim.core.entity.WorldObjectDefinition;
import org.auvsim.core.math.Draws;
import org.auvsim.core.math.Vec3;
import org.auvsim.core.volume.Box;
import org.auvsim.core.volume.Capsule;
import org.auvsim.core.volume.Sphere;
import org.auvsim.core.volume.Volume;
import org.auvsim.core.world.World;
import org.auvsim.core.world.WorldBuilder;
import org.auvsim.core.world.WorldEvent;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;

import java.util.stream.LongStream;

/** No contact adds energy, whatever the volumes, restitution and friction. */
class StepEnergyTest {
    static LongStream seeds() {
        return LongStream.rangeClosed(1, 20);
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
            builder.add(drawn(body, i, draws).build());
        }
        World world = builder.build();
        int[] collisions = {0};
        world.addListener(e -> collisions[0] += e instanceof WorldEvent.Collided ? 1 : 0);
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

        assertThat(collisions[0]).isPositive();
        assertThat(momentum(world).distance(momentum)).isLessThan(1e-11);
    }

    private static Vec3 momentum(World world) {
        return world.objects().stream().map(o -> o.linearMomentum()).reduce(Vec3.ZERO, Vec3::plus);
    }

    /** Section 8.2 of the thesis, smaller, with bodies that lose energy in each collision. */
    @ParameterizedTest(name = "restitution {0}")
    @ValueSource(doubles = {0.9, 0.5, 0})
    void aSwarmThatGathersNeverGetsStuck(double restitution) {
        Draws draws = new Draws(1);
        WorldBuilder builder = World.builder().stepper(EventStepper.standard());
        for (int i = 0; i < 27; i++) {
            Vec3 cell = new Vec3(i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1);
            builder.add(
                    Scene.ball("Ball " + i, 0.5)
                            .restitution(restitution)
                            .position(cell.times(6).plus(draws.vector(1e-6)))
                            .effect(new CentralForce(10, 0.1, draws.direction().times(2)))
                            .build());
        }
        World world = builder.build();

        Ground.run(world, 30);

        for (int i = 0; i < 27; i++) {
            for (int j = 0; j < i; j++) {
                Vec3 one = world.objects().get(i).position();
                Vec3 other = world.objects().get(j).position();
                assertThat(one.distance(other)).as("%d and %d", i, j).isGreaterThan(1 - 1e-9);
            }
        }
    }
}
