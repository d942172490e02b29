package org.auvsim.core.step;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import org.auvsim.core.effect.CentralForce;
import org.auvsim.core.math.Draws;
import org.auvsim.core.math.Vec3;
import org.auvsim.core.world.World;
import org.auvsim.core.world.WorldBuilder;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Section 8.2 of the thesis, smaller, with bodies that lose energy in each collision. */
class NeverStuckTest {
    private static final int BALLS = 27;

    private static World swarm(double restitution) {
        Draws draws = new Draws(1);
        WorldBuilder builder = World.builder().stepper(EventStepper.standard());
        for (int i = 0; i < BALLS; i++) {
            Vec3 cell = new Vec3(i % 3 - 1, Math.floorDiv(i, 3) % 3 - 1, Math.floorDiv(i, 9) - 1);
            builder.add(
                    Scene.ball("Ball " + i, 0.5)
                            .restitution(restitution)
                            .position(cell.times(6).plus(draws.vector(1e-6)))
                            .effect(new CentralForce(10, 0.1, draws.direction().times(2)))
                            .build());
        }
        return builder.build();
    }

    /** Where the bound on events a step is passed, the step fails. */
    @ParameterizedTest(name = "restitution {0}")
    @ValueSource(doubles = {0.9, 0.5, 0})
    void aSwarmThatGathersGoesOn(double restitution) {
        World world = swarm(restitution);

        Ground.run(world, 30);

        assertThat(world.time()).isGreaterThanOrEqualTo(30);
        assertThat(Ground.kineticEnergy(world) / BALLS).isLessThan(30);
    }

    @ParameterizedTest(name = "restitution {0}")
    @ValueSource(doubles = {1, 0.9, 0.5, 0})
    void ballsNeverOverlap(double restitution) {
        World world = swarm(restitution);

        while (world.time() < 30) {
            world.advanceTimestep();
            assertThat(deepestOverlap(world)).as("at %s s", world.time()).isLessThan(1e-9);
        }
    }

    /** In diameters; negative while all are apart. */
    private static double deepestOverlap(World world) {
        double deepest = Double.NEGATIVE_INFINITY;
        for (int i = 0; i < BALLS; i++) {
            for (int j = 0; j < i; j++) {
                Vec3 one = world.objects().get(i).position();
                Vec3 other = world.objects().get(j).position();
                deepest = Math.max(deepest, 1 - one.distance(other));
            }
        }
        return deepest;
    }

    @Test
    void aBallThatBouncesWithoutEndInOneStepIsAnErrorAndNothingHasMoved() {
        World world =
                World.builder()
                        .stepper(EventStepper.standard())
                        .add(Ground.floor(0))
                        .add(Ground.plane("Lid", new Vec3(0, 0, 0.201), new Vec3(1e-9, 0, -1), 0))
                        .add(
                                Scene.ball("Ball", 0.1)
                                        .position(0, 0, 0.1005)
                                        .velocity(0, 0, 1000)
                                        .build())
                        .build();
        long before = world.stateHash();

        assertThatThrownBy(world::advanceTimestep)
                .isInstanceOf(StepException.class)
                .hasMessageContaining("'Ball'")
                .hasMessageContaining(" collide without end at ")
                .hasMessageContaining(" events in one step; check their forces and restitution");
        assertThat(world.stateHash()).isEqualTo(before);
    }
}
