package org.auvsim.core.step;

import static org.assertj.core.api.Assertions.assertThat;

import org.auvsim.core.entity.AddedMass;
import org.auvsim.core.entity.AddedMassTerm;
import org.auvsim.core.entity.MotionAxis;
import org.auvsim.core.entity.WorldObjectDefinition;
import org.auvsim.core.math.Draws;
import org.auvsim.core.math.Vec3;
import org.auvsim.core.volume.Box;
import org.auvsim.core.volume.Capsule;
import org.auvsim.core.volume.Compound;
import org.auvsim.core.volume.Part;
import org.auvsim.core.volume.Sphere;
import org.auvsim.core.volume.Volume;
import org.auvsim.core.world.World;
import org.auvsim.core.world.WorldBuilder;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;

import java.util.Arrays;
import java.util.List;
import java.util.function.ToDoubleFunction;
import java.util.stream.LongStream;

/** No contact adds energy, whatever the volumes, inertia, restitution and friction. */
class StepEnergyTest {
    static List<Arguments> draws() {
        return eachSetting(20);
    }

    static List<Arguments> manyDraws() {
        return eachSetting(200);
    }

    private static List<Arguments> eachSetting(long seeds) {
        return Arrays.stream(Setting.values())
                .flatMap(
                        setting ->
                                LongStream.rangeClosed(1, seeds)
                                        .mapToObj(seed -> Arguments.of(setting, seed)))
                .toList();
    }

    /** What the bodies are, and how finely what they do is stepped through. */
    enum Setting {
        /** Solid bodies at the standard time step. */
        DRY(0.05) {
            @Override
            Volume volume(Draws draws) {
                double kind = draws.number(0, 3);
                if (kind < 1) {
                    return new Sphere(draws.number(0.2, 0.5));
                }
                return kind < 2
                        ? new Box(draws.vector(0.3, 0.9))
                        : new Capsule(draws.number(0.15, 0.3), draws.number(0.2, 0.6));
            }

            @Override
            WorldObjectDefinition.Builder inertia(WorldObjectDefinition.Builder body, Draws draws) {
                return body;
            }
        },

        /**
         * Also two volumes in one body; every second body carries water along, and its centre of
         * mass is off its origin. Such bodies tumble at 10 rad/s: a step of 0.02 s integrates that
         * with no more energy than the contacts may give.
         */
        LOADED(0.02) {
            @Override
            Volume volume(Draws draws) {
                double kind = draws.number(0, 4);
                if (kind < 1) {
                    return new Sphere(draws.number(0.2, 0.5));
                }
                if (kind < 2) {
                    return new Box(draws.vector(0.3, 0.7));
                }
                return kind < 3
                        ? new Capsule(draws.number(0.15, 0.3), draws.number(0.2, 0.6))
                        : twoParts(draws);
            }

            @Override
            WorldObjectDefinition.Builder inertia(WorldObjectDefinition.Builder body, Draws draws) {
                return draws.number(0, 2) < 1
                        ? body
                        : body.centreOfMass(draws.vector(0.1)).addedMass(water(draws));
            }
        };

        private final double timeStep;

        Setting(double timeStep) {
            this.timeStep = timeStep;
        }

        WorldBuilder world() {
            return World.builder().timeStep(timeStep).stepper(EventStepper.standard());
        }

        /** One within 0.7 m of the origin. */
        abstract Volume volume(Draws draws);

        abstract WorldObjectDefinition.Builder inertia(
                WorldObjectDefinition.Builder body, Draws draws);

        private static Volume twoParts(Draws draws) {
            return new Compound(
                    List.of(
                            new Part(
                                    new Box(draws.vector(0.3, 0.5)),
                                    draws.vector(0.1),
                                    draws.orientation()),
                            new Part(
                                    new Sphere(draws.number(0.15, 0.3)),
                                    draws.vector(0.15),
                                    draws.orientation())));
        }

        private static AddedMass water(Draws draws) {
            return new AddedMass(
                    draws.vector(0.1, 3),
                    draws.vector(0.05, 0.5),
                    List.of(
                            new AddedMassTerm(
                                    MotionAxis.SWAY, MotionAxis.YAW, draws.number(-0.05, 0.05))));
        }
    }

    private static WorldObjectDefinition.Builder drawn(
            Setting setting, WorldObjectDefinition.Builder body, int i, Draws draws) {
        Vec3 velocity = draws.vector(2);
        Vec3 spin = draws.vector(1);
        return setting.inertia(body, draws)
                .restitution(draws.number(-0.3, 1.3) < 0.5 ? 0 : draws.number(0, 1))
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

    @ParameterizedTest(name = "{0}, seed {1}")
    @MethodSource("draws")
    void inARoomUnderGravityEnergyOnlyFalls(Setting setting, long seed) {
        Draws draws = new Draws(seed);
        WorldBuilder builder = setting.world();
        Ground.room(5, draws.number(0, 1)).forEach(builder::add);
        for (int i = 0; i < 12; i++) {
            builder.add(
                    drawn(setting, Ground.heavy("Body " + i, setting.volume(draws)), i, draws)
                            .build());
        }
        World world = builder.build();
        double start = Ground.energy(world);

        double end = energyAfterOnlyLosses(world, 4, Ground::energy, 1e-5);

        assertThat(end).isLessThan(start);
    }

    @ParameterizedTest(name = "{0}, seed {1}")
    @MethodSource("draws")
    void inTheVoidEnergyOnlyFallsAndMomentumStays(Setting setting, long seed) {
        Draws draws = new Draws(seed);
        WorldBuilder builder = setting.world();
        for (int i = 0; i < 18; i++) {
            WorldObjectDefinition.Builder body =
                    WorldObjectDefinition.named("Body " + i)
                            .volume(setting.volume(draws))
                            .mass(draws.number(0.5, 2));
            builder.add(towardsTheMiddle(drawn(setting, body, i, draws), i, draws).build());
        }
        World world = builder.build();
        Vec3 momentum = momentum(world);

        energyAfterOnlyLosses(world, 3, Ground::kineticEnergy, 1e-6);

        assertThat(world.statistics().collisions()).isPositive();
        assertThat(momentum(world).distance(momentum)).isLessThan(1e-11);
    }

    /** What stands on one end, tumbles or rolls to rest is held for many frames. */
    @ParameterizedTest(name = "{0}, seed {1}")
    @MethodSource("manyDraws")
    void oneBodyThatFallsOnAFloorGainsNothing(Setting setting, long seed) {
        Draws draws = new Draws(seed);
        World world =
                setting.world()
                        .add(Ground.floor(draws.number(0, 1)))
                        .add(
                                drawn(
                                                setting,
                                                Ground.heavy("Body", setting.volume(draws)),
                                                4,
                                                draws)
                                        .build())
                        .build();

        energyAfterOnlyLosses(world, 4, Ground::energy, 1e-5);

        StepStatistics met = world.statistics();
        assertThat(met.collisions() + met.heldPairs()).isPositive();
    }

    /** Runs to an end (s); no step may gain more than a share of what energy (J) there was. */
    private static double energyAfterOnlyLosses(
            World world, double end, ToDoubleFunction<World> energy, double share) {
        double start = energy.applyAsDouble(world);
        double before = start;
        while (world.time() < end) {
            world.advanceTimestep();
            double now = energy.applyAsDouble(world);
            assertThat(now - before)
                    .as("gain (J) up to %s s", world.time())
                    .isLessThan(share * start);
            before = now;
        }
        return before;
    }

    private static Vec3 momentum(World world) {
        return world.objects().stream().map(o -> o.linearMomentum()).reduce(Vec3.ZERO, Vec3::plus);
    }
}
