package org.auvsim.core.step;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.auvsim.core.entity.WorldObject;
import org.auvsim.core.math.Draws;
import org.auvsim.core.math.Vec3;
import org.auvsim.core.volume.Box;
import org.auvsim.core.volume.Sphere;
import org.auvsim.core.world.World;
import org.auvsim.core.world.WorldBuilder;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

import java.util.List;

/** Bodies that lie on each other stay where they are, and what falls comes to rest. */
class StackTest {
    private static WorldBuilder world() {
        return World.builder().stepper(EventStepper.standard());
    }

    @ParameterizedTest(name = "restitution {0}, friction {1}")
    @CsvSource({"0, 0.5", "0.5, 0.5", "0, 0.1"})
    void tenBoxesStandForAMinute(double restitution, double friction) {
        WorldBuilder builder = world().add(Ground.floor(friction));
        for (int i = 0; i < 10; i++) {
            builder.add(
                    Ground.heavy("Box " + i, new Box(new Vec3(1, 1, 1)))
                            .restitution(restitution)
                            .friction(friction)
                            .position(0, 0, 0.5 + i)
                            .build());
        }
        World world = builder.build();

        Ground.run(world, 60);

        for (int i = 0; i < 10; i++) {
            WorldObject box = world.object("Box " + i);
            assertThat(box.position().distance(new Vec3(0, 0, 0.5 + i)))
                    .as("drift of box %d: %s", i, box.position())
                    .isLessThan(1e-3);
            assertThat(Math.abs(box.orientation().w()))
                    .as("turn of box %d", i)
                    .isGreaterThan(1 - 1e-6);
        }
    }

    @Test
    void aPileOfFiftyBallsComesToRest() {
        Draws draws = new Draws(1);
        WorldBuilder builder = world();
        Ground.room(2.2, 0.4).forEach(builder::add);
        for (int i = 0; i < 50; i++) {
            builder.add(
                    Ground.heavy("Ball " + i, new Sphere(0.25))
                            .restitution(0.3)
                            .friction(0.4)
                            .position(
                                    0.54 * (i % 4 - 1.5) + draws.number(-0.02, 0.02),
                                    0.54 * (i / 4 % 4 - 1.5) + draws.number(-0.02, 0.02),
                                    0.3 + 0.54 * Math.floorDiv(i, 16))
                            .build());
        }
        World world = builder.build();

        Ground.run(world, 5);
        List<Vec3> before = Ground.movers(world).stream().map(WorldObject::position).toList();
        Ground.run(world, 6);

        double energy = Ground.kineticEnergy(world) / 50;
        assertThat(energy).as("kinetic energy a ball (J)").isLessThan(1e-5);
        List<WorldObject> balls = Ground.movers(world);
        for (int i = 0; i < 50; i++) {
            Vec3 place = balls.get(i).position();
            assertThat(place.distance(before.get(i))).as("ball %d in a second", i).isLessThan(1e-2);
            assertThat(place.z()).as("height of ball %d", i).isGreaterThan(0.25 - 1e-9);
            assertThat(Math.max(Math.abs(place.x()), Math.abs(place.y())))
                    .as("ball %d and the walls", i)
                    .isLessThan(0.85 + 1e-9);
            for (int j = 0; j < i; j++) {
                assertThat(place.distance(balls.get(j).position()))
                        .as("balls %d and %d", i, j)
                        .isGreaterThan(0.5 * (1 - 1e-9));
            }
        }
    }

    @Test
    void aBallThatBouncesHalfAsFastComesToRest() {
        World world =
                world().add(Ground.floor(0))
                        .add(
                                Ground.heavy("Ball", new Sphere(0.5))
                                        .restitution(0.5)
                                        .position(0, 0, 2.5)
                                        .build())
                        .timeStep(0.01)
                        .build();
        // Falls 2 m in T, then flies for T, T/2, T/4 ...: the k-th top is 2 m * 0.25^k high.
        double fall = Math.sqrt(2 * 2 / Ground.G);
        double top = fall;
        for (int k = 1; k <= 5; k++) {
            double flight = 2 * fall * StrictMath.pow(0.5, k);
            while (top + flight / 2 - world.time() > 1e-12) {
                world.advanceTimestep(Math.min(0.01, top + flight / 2 - world.time()));
            }
            double height = 2 * StrictMath.pow(0.25, k);
            assertThat(world.object("Ball").position().z() - 0.5)
                    .as("top %d", k)
                    .isEqualTo(height, within(1e-5));
            top += flight;
        }

        Ground.run(world, 5);

        assertThat(world.object("Ball").velocity().norm()).isLessThan(1e-9);
        assertThat(world.object("Ball").position().z()).isEqualTo(0.5, within(1e-4));
    }
}
