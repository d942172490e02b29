package org.auvsim.core.world;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.junit.jupiter.params.provider.Arguments.arguments;

import org.auvsim.core.actuator.Propulsor;
import org.auvsim.core.effect.Gravity;
import org.auvsim.core.entity.Block;
import org.auvsim.core.entity.BodyEffect;
import org.auvsim.core.entity.BodyState;
import org.auvsim.core.entity.CoupledEffect;
import org.auvsim.core.entity.Frame;
import org.auvsim.core.entity.NamedForce;
import org.auvsim.core.entity.WorldObjectDefinition;
import org.auvsim.core.math.Vec3;
import org.auvsim.core.step.AllPairsPartitioner;
import org.auvsim.core.step.EndOfStepFinder;
import org.auvsim.core.step.NoRestricter;
import org.auvsim.core.step.SnapshotStepper;
import org.auvsim.core.step.StepException;
import org.auvsim.core.volume.Sphere;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;

import java.util.List;
import java.util.stream.Stream;

class RunawayTest {
    @Test
    void aBodyWhoseNumbersOverflowIsNamedAndNothingHasMoved() {
        World world =
                World.builder()
                        .stepper(
                                new SnapshotStepper(
                                        new NoRestricter(),
                                        new AllPairsPartitioner(),
                                        new EndOfStepFinder()))
                        .add(
                                WorldObjectDefinition.named("Rocket")
                                        .volume(new Sphere(1))
                                        .mass(1e-3)
                                        .build())
                        .build();
        Vec3 huge = new Vec3(1e308, 0, 0);
        world.object("Rocket").applyForce(NamedForce.direct("Engine", Frame.WORLD, huge));
        long before = world.stateHash();

        assertThatThrownBy(world::advanceTimestep)
                .isInstanceOf(StepException.class)
                .hasMessage(
                        "the motion of 'Rocket' (id 1) gets out of all bounds between 0.0 s and"
                                + " 0.05 s by its named force 'Engine', the largest of its forces;"
                                + " lessen its forces or the time step");
        assertThat(world.stateHash()).isEqualTo(before);
    }

    private static WorldObjectDefinition.Builder fleck() {
        return WorldObjectDefinition.named("Fleck").volume(new Sphere(0.1)).mass(1e-3);
    }

    private static final Propulsor WEAK = propulsor("Weak", 1e300);
    private static final Propulsor STRONG = propulsor("Strong", 1e306);

    private static Propulsor propulsor(String name, double thrust) {
        return new Propulsor(name, thrust, 1, Vec3.ZERO, new Vec3(1, 0, 0));
    }

    static Stream<Arguments> finiteForces() {
        NamedForce force = NamedForce.direct("Gale", Frame.BODY, new Vec3(0, -1e305, 0));
        Gravity gravity = new Gravity(1e307);
        return Stream.of(
                arguments(
                        "its effect 'gravity', the largest of its forces",
                        fleck().component(WEAK).effect(gravity)),
                arguments(
                        "its named force 'Gale', the largest of its forces",
                        fleck().component(WEAK).force(force).effect(gravity)),
                arguments(
                        "its propulsor 'Strong', the largest of its forces",
                        fleck().component(WEAK).component(STRONG).force(force)),
                arguments("its own speed", fleck().velocity(Double.MAX_VALUE, 0, 0)));
    }

    @ParameterizedTest(name = "{0}")
    @MethodSource("finiteForces")
    void whereEveryForceIsFiniteTheLargestIsNamed(
            String culprit, WorldObjectDefinition.Builder body) {
        World world = World.builder().timeStep(10).add(body.build()).build();

        assertThatThrownBy(
                        () -> {
                            while (world.time() < 1000) {
                                world.advanceTimestep();
                            }
                        })
                .isInstanceOf(StepException.class)
                .hasMessageContaining(" by " + culprit + "; ");
    }

    @Test
    void ofFiniteForcesWhoseSumIsNotTheLargestIsNamed() {
        World world =
                World.builder()
                        .add(
                                fleck().component(propulsor("One", 1e308))
                                        .component(propulsor("Other", 1.2e308))
                                        .build())
                        .build();

        assertThatThrownBy(world::advanceTimestep)
                .isInstanceOf(StepException.class)
                .hasMessageContaining(" by its propulsor 'Other', the largest of its forces; ");
    }

    /** Pulls with a force that has a pole where x is 1 m. */
    private record PoleForce() implements BodyEffect {
        @Override
        public void add(Block block, int i) {
            double x = block.state[BodyState.X][i];
            block.addForce(i, new Vec3(x < 1 ? 1 / (1 - x) : Double.NaN, 0, 0));
        }
    }

    @Test
    void theEffectThatDidItIsNamedAndTheLastGoodStateStays() {
        World world =
                World.builder()
                        .add(
                                WorldObjectDefinition.named("Probe")
                                        .volume(new Sphere(0.1))
                                        .mass(1)
                                        .velocity(1, 0, 0)
                                        .effect(new Gravity(9.80665))
                                        .effect(new PoleForce())
                                        .build())
                        .build();

        assertThatThrownBy(
                        () -> {
                            while (world.time() < 10) {
                                world.advanceTimestep();
                            }
                        })
                .isInstanceOf(StepException.class)
                .hasMessageContaining("'Probe' (id 1) gets out of all bounds between ")
                .hasMessageContaining(" by its effect 'pole-force'; ");
        assertThat(world.object("Probe").position().x()).isBetween(0.5, 1.0);
        assertThat(world.object("Probe").linearMomentum().isFinite()).isTrue();
        long kept = world.stateHash();
        assertThatThrownBy(world::advanceTimestep).isInstanceOf(StepException.class);
        assertThat(world.stateHash()).isEqualTo(kept);
    }

    /** Pulls its body and one other apart with a force that has a pole where x is 1 m. */
    private record PoleTie(List<Long> partners) implements CoupledEffect {
        @Override
        public void add(Block block, int i, int[] others) {
            double x = block.state[BodyState.X][i];
            double pull = x < 1 ? 1 / (1 - x) : Double.NaN;
            block.addForce(i, new Vec3(pull, 0, 0));
            block.addForce(others[0], new Vec3(-pull, 0, 0));
        }
    }

    @ParameterizedTest(name = "owner is number {0}")
    @CsvSource({"2, the effect 'pole-tie' of 'Owner'", "1, its effect 'pole-tie'"})
    void aCoupledEffectThatDidItIsNamedWithItsOwner(int owner, String culprit) {
        WorldObjectDefinition.Builder tied =
                WorldObjectDefinition.named("Owner")
                        .volume(new Sphere(0.1))
                        .mass(1)
                        .velocity(1, 0, 0)
                        .effect(new PoleTie(List.of(3L - owner)));
        WorldObjectDefinition other =
                WorldObjectDefinition.named("Other")
                        .volume(new Sphere(0.1))
                        .mass(1)
                        .position(0, 5, 0)
                        .build();
        WorldBuilder builder = World.builder();
        World world =
                owner == 1
                        ? builder.add(tied.build()).add(other).build()
                        : builder.add(other).add(tied.build()).build();

        assertThatThrownBy(
                        () -> {
                            while (world.time() < 10) {
                                world.advanceTimestep();
                            }
                        })
                .isInstanceOf(StepException.class)
                .hasMessageContaining("(id 1) gets out of all bounds between ")
                .hasMessageContaining(" by " + culprit + "; ");
    }
}
