package org.auvsim.core.world;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import org.auvsim.core.entity.Behavior;
import org.auvsim.core.entity.Change;
import org.auvsim.core.entity.Frame;
import org.auvsim.core.entity.NamedForce;
import org.auvsim.core.entity.WorldObject;
import org.auvsim.core.math.Vec3;
import org.auvsim.core.step.SnapshotStepper;
import org.junit.jupiter.api.Test;

import java.util.ArrayList;
import java.util.List;

class WorldStepTest {
    private record Noting(String name, List<String> notes) implements Behavior {
        @Override
        public void act(double time, WorldObject self) {
            notes.add("%s of %d at %s".formatted(name, self.id(), time));
        }
    }

    @Test
    void behaviorsActOnceBeforeEachStepInOrderOfId() {
        List<String> notes = new ArrayList<>();
        World world =
                World.builder()
                        .timeStep(0.5)
                        .add(Balls.ball("B").id(9).component(new Noting("c", notes)).build())
                        .add(
                                Balls.ball("A")
                                        .id(2)
                                        .position(9, 0, 0)
                                        .component(new Noting("z", notes))
                                        .component(new Noting("a", notes))
                                        .build())
                        .build();

        world.advanceTimestep();
        world.advanceTimestep();

        assertThat(notes)
                .containsExactly(
                        "z of 2 at 0.0",
                        "a of 2 at 0.0",
                        "c of 9 at 0.0",
                        "z of 2 at 0.5",
                        "a of 2 at 0.5",
                        "c of 9 at 0.5");
    }

    @Test
    void theClockDoesNotDrift() {
        World world = World.builder().timeStep(0.1).build();

        for (int step = 0; step < 200_000; step++) {
            world.advanceTimestep();
        }

        assertThat(world.time()).isEqualTo(20_000, within(1e-11));
    }

    @Test
    void aCollisionThatNeverEndsIsAnError() {
        World world =
                World.builder()
                        .allowOverlaps()
                        .response(contact -> List.of())
                        .add(Balls.ball("A").velocity(1, 0, 0).build())
                        .add(Balls.ball("B").position(0.9, 0, 0).build())
                        .build();

        assertThatThrownBy(
                        () -> {
                            for (int step = 0; step <= 10_000; step++) {
                                world.advanceTimestep();
                            }
                        })
                .isInstanceOf(WorldException.class)
                .hasMessageContaining("stands still at 0.0 s: A and B collide again and again");
    }

    /** What feedback does when it moves a body into another one. */
    @Test
    void aBodyThatIsMovedIntoAnotherRespondsAtOnceIfTheyApproach() {
        World world = pair(-1);
        world.object("A").setPosition(new Vec3(0.8, 0, 0));

        assertThat(world.overlaps(1)).containsExactly(2L);
        world.advanceTimestep();
        assertThat(world.object("A").velocity().x()).isEqualTo(0, within(1e-12));
        assertThat(world.object("B").velocity().x()).isEqualTo(-1, within(1e-12));
    }

    @Test
    void aBodyThatIsMovedIntoAnotherIsLeftAloneWhileTheyPart() {
        World world = pair(1);
        int[] collisions = {0};
        world.addListener(event -> collisions[0] += event instanceof WorldEvent.Collided ? 1 : 0);
        world.object("A").setPosition(new Vec3(0.82, 0, 0));

        while (!world.overlaps(1).isEmpty()) {
            assertThat(world.advanceTimestep()).isEqualTo(0.05);
        }

        assertThat(world.time()).isEqualTo(0.2, within(1e-12));
        assertThat(collisions[0]).isZero();
        // Apart, they are an ordinary pair again.
        world.object("A").setVelocity(new Vec3(-1, 0, 0));
        while (collisions[0] == 0 && world.time() < 1) {
            world.advanceTimestep();
        }
        assertThat(collisions[0]).isEqualTo(1);
        assertThat(world.object("B").velocity().x()).isEqualTo(-1, within(1e-9));
    }

    private static World pair(double speed) {
        return World.builder()
                .add(Balls.ball("A").position(5, 0, 0).velocity(speed, 0, 0).build())
                .add(Balls.at("B", 0))
                .build();
    }

    @Test
    void anEntityLeavesWhenItIsOver() {
        World world = World.builder().timeStep(0.4).add(Wave.at(5, 0)).build();
        List<WorldEvent> events = new ArrayList<>();
        world.addListener(events::add);

        world.advanceTimestep();
        world.advanceTimestep();
        assertThat(world.find(5)).isPresent();
        world.advanceTimestep();

        assertThat(world.find(5)).isEmpty();
        assertThat(events).contains(new WorldEvent.EntityRemoved(world.time(), 5));
    }

    /** Both meetings happen at one instant; if one were forgotten, it would happen again. */
    @Test
    void ofTwoUpdatesAtOneInstantNoneIsLost() {
        World world =
                World.builder()
                        .timeStep(0.4)
                        .add(Wave.at(5, 0))
                        .add(Balls.at("Left", -3))
                        .add(Balls.at("Right", 3))
                        .build();
        int[] collisions = {0};
        world.addListener(event -> collisions[0] += event instanceof WorldEvent.Collided ? 1 : 0);

        for (int step = 0; step < 4; step++) {
            world.advanceTimestep();
        }

        assertThat(collisions[0]).isEqualTo(2);
    }

    @Test
    void anUpdateOfWhoHasLeftChangesNothing() {
        World world =
                World.builder()
                        .stepper(SnapshotStepper.standard())
                        .allowOverlaps()
                        .response(
                                contact ->
                                        List.of(
                                                new Change.Remove(77),
                                                new Change.Update<>(77, Wave.class, wave -> wave),
                                                new Change.Momentum(77, Vec3.ZERO, Vec3.ZERO)))
                        .add(Balls.ball("A").velocity(1, 0, 0).build())
                        .add(Balls.at("B", 0.9))
                        .build();

        assertThat(world.advanceTimestep()).isZero();
        assertThat(world.entities()).hasSize(2);
    }

    @Test
    void aNamedForceActsOverTheStep() {
        World world = World.builder().timeStep(0.5).add(Balls.at("A", 0)).build();
        world.object("A").applyForce(NamedForce.direct("Push", Frame.WORLD, new Vec3(2, 0, 0)));

        world.advanceTimestep();

        assertThat(world.object("A").position().x()).isEqualTo(0.25, within(1e-15));
        assertThat(world.object("A").velocity().x()).isEqualTo(1, within(1e-15));
    }
}
