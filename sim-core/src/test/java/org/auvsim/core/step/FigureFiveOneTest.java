package org.auvsim.core.step;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.auvsim.core.entity.WorldObjectDefinition;
import org.auvsim.core.math.Vec3;
import org.auvsim.core.volume.Sphere;
import org.auvsim.core.world.World;
import org.auvsim.core.world.WorldBuilder;
import org.auvsim.core.world.WorldEvent;
import org.junit.jupiter.api.Test;

import java.util.ArrayList;
import java.util.List;

/** The case of the thesis' Figure 5.1: two objects whose paths cross in mid-step. */
class FigureFiveOneTest {
    private static final double CONTACT = (1 - 1 / Math.sqrt(2)) / 2;

    private static WorldBuilder crossing() {
        return World.builder()
                .timeStep(1)
                .add(ball("A").position(-1, 0, 0).velocity(2, 0, 0).build())
                .add(ball("B").position(0, -1, 0).velocity(0, 2, 0).build());
    }

    private static WorldObjectDefinition.Builder ball(String name) {
        return WorldObjectDefinition.named(name).volume(new Sphere(0.5)).mass(1);
    }

    @Test
    void theStepEndsAtTheContact() {
        World world = crossing().stepper(SnapshotStepper.standard()).build();

        assertThat(world.advanceTimestep()).isEqualTo(CONTACT, within(1e-10));
        assertThat(world.time()).isEqualTo(CONTACT, within(1e-10));
    }

    @Test
    void theTwoExchangeTheirMomentaAlongTheNormal() {
        World world = crossing().build();
        List<WorldEvent> events = new ArrayList<>();
        world.addListener(events::add);

        world.advanceTimestep();

        // The normal is (-1, 1, 0) / sqrt 2, along which they approach with 2 sqrt 2 m/s.
        assertThat(world.object("A").velocity().distance(new Vec3(0, 2, 0))).isLessThan(1e-9);
        assertThat(world.object("B").velocity().distance(new Vec3(2, 0, 0))).isLessThan(1e-9);
        assertThat(events).first().isInstanceOf(WorldEvent.Collided.class);
        assertThat(events).last().isInstanceOf(WorldEvent.StepAdvanced.class);
    }

    @Test
    void withoutRestrictionAndSearchTheCollisionIsMissed() {
        World world =
                crossing()
                        .stepper(
                                new SnapshotStepper(
                                        new NoRestricter(),
                                        new AllPairsPartitioner(),
                                        new EndOfStepFinder()))
                        .build();

        assertThat(world.advanceTimestep()).isEqualTo(1);
        assertThat(world.object("A").velocity()).isEqualTo(new Vec3(2, 0, 0));
    }
}
