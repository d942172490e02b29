package org.auvsim.core.world;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

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
                .hasMessageContaining("'Rocket' (id 1)")
                .hasMessageContaining("lessen its forces or the time step");
        assertThat(world.stateHash()).isEqualTo(before);
    }
}
