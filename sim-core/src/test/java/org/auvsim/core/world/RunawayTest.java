package org.auvsim.core.world;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

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
import org.junit.jupiter.params.provider.CsvSource;

import java.util.List;

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
                                + " 0.05 s by the sum of its forces; lessen its forces or the time"
                                + " step");
        assertThat(world.stateHash()).isEqualTo(before);
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
