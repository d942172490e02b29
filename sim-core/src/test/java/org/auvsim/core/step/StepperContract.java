package org.auvsim.core.step;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.auvsim.core.entity.WorldObject;
import org.auvsim.core.entity.WorldObjectDefinition;
import org.auvsim.core.math.Vec3;
import org.auvsim.core.volume.Sphere;
import org.auvsim.core.world.World;
import org.auvsim.core.world.WorldBuilder;
import org.auvsim.core.world.WorldEvent;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import java.util.SplittableRandom;

/** What every {@link Stepper} keeps; extend it to test one of your own. */
public abstract class StepperContract {
    private static final double DT = 0.05;

    /** The stepper, made to cope with speeds of up to 10 m/s. */
    protected abstract Stepper stepper();

    /** Balls on a lattice, apart at first, that fly toward each other. */
    private World swarm(long seed) {
        SplittableRandom random = new SplittableRandom(seed);
        WorldBuilder world = World.builder().timeStep(DT).stepper(stepper());
        for (int i = 0; i < 27; i++) {
            Vec3 cell = new Vec3(i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1);
            world.add(
                    WorldObjectDefinition.named("Ball " + i)
                            .volume(new Sphere(random.nextDouble(0.2, 0.5)))
                            .mass(random.nextDouble(0.5, 2))
                            .position(cell.times(1.5))
                            .velocity(
                                    random.nextDouble(-1, 1) - cell.x(),
                                    random.nextDouble(-1, 1) - cell.y(),
                                    random.nextDouble(-1, 1) - cell.z())
                            .build());
        }
        return world.build();
    }

    @ParameterizedTest(name = "seed {0}")
    @ValueSource(longs = {1, 2, 3, 4, 5})
    void momentumAngularMomentumAndEnergyAreKeptInFreeSpace(long seed) {
        World world = swarm(seed);
        int[] collisions = {0};
        world.addListener(event -> collisions[0] += event instanceof WorldEvent.Collided ? 1 : 0);
        Vec3 momentum = momentum(world);
        Vec3 angularMomentum = angularMomentum(world);
        double energy = energy(world);

        while (world.time() < 3) {
            world.advanceTimestep();
        }

        assertThat(collisions[0]).isPositive();
        assertThat(momentum(world).distance(momentum)).isLessThan(1e-11);
        assertThat(angularMomentum(world).distance(angularMomentum)).isLessThan(1e-10);
        assertThat(energy(world)).isEqualTo(energy, within(1e-9 * energy));
    }

    @ParameterizedTest(name = "seed {0}")
    @ValueSource(longs = {6, 7, 8})
    void noStepIsLongerThanWantedOrGoesBack(long seed) {
        World world = swarm(seed);
        for (int step = 0; step < 100; step++) {
            assertThat(world.advanceTimestep()).isBetween(0.0, DT);
        }
        assertThat(world.time()).isPositive();
    }

    @ParameterizedTest(name = "seed {0}")
    @ValueSource(longs = {9, 10, 11})
    void equalWorldsStayEqualBitForBit(long seed) {
        World one = swarm(seed);
        World other = swarm(seed);
        for (int step = 0; step < 100; step++) {
            one.advanceTimestep();
            other.advanceTimestep();
            assertThat(other.stateHash()).isEqualTo(one.stateHash());
        }
    }

    private static Vec3 momentum(World world) {
        return world.objects().stream()
                .map(WorldObject::linearMomentum)
                .reduce(Vec3.ZERO, Vec3::plus);
    }

    /** About the world's origin. */
    private static Vec3 angularMomentum(World world) {
        return world.objects().stream()
                .map(o -> o.angularMomentum().plus(o.position().cross(o.linearMomentum())))
                .reduce(Vec3.ZERO, Vec3::plus);
    }

    private static double energy(World world) {
        return world.objects().stream()
                .mapToDouble(
                        o ->
                                o.linearMomentum().dot(o.velocity()) / 2
                                        + o.angularMomentum().dot(o.angularVelocity()) / 2)
                .sum();
    }
}
