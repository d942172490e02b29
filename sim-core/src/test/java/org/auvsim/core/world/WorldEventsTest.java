package org.auvsim.core.world;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.auvsim.core.dynamics.ImpulseResponse;
import org.auvsim.core.entity.Change;
import org.auvsim.core.entity.CollisionResponse;
import org.auvsim.core.entity.Contact;
import org.auvsim.core.entity.WorldObjectDefinition;
import org.auvsim.core.math.Vec3;
import org.junit.jupiter.api.Test;

import java.util.ArrayList;
import java.util.List;

class WorldEventsTest {
    private static List<String> kinds(List<WorldEvent> events) {
        return events.stream().map(e -> e.getClass().getSimpleName()).toList();
    }

    /** A heap of snow: breaks when hit, and leaves two flakes behind. */
    private record Breaks() implements CollisionResponse {
        @Override
        public List<Change> respond(Contact contact) {
            return List.of(
                    new Change.Remove(contact.self().id()),
                    new Change.AddObject(Balls.at("Flake 1", 50)),
                    new Change.AddObject(Balls.at("Flake 2", 60)));
        }
    }

    private static World pitch() {
        WorldObjectDefinition heap = Balls.ball("Heap").response(new Breaks()).build();
        return World.builder()
                .add(heap)
                .add(Balls.ball("Stone").position(1.02, 0, 0).velocity(-1, 0, 0).build())
                .build();
    }

    @Test
    void aStepTellsCollisionsThenWhatCameAndLeftThenMovementsThenItsEnd() {
        World world = pitch();
        List<WorldEvent> events = new ArrayList<>();
        world.addListener(events::add);

        world.advanceTimestep();

        assertThat(kinds(events))
                .containsExactly(
                        "Collided",
                        "EntityRemoved",
                        "EntityAdded",
                        "ObjectAdded",
                        "EntityAdded",
                        "ObjectAdded",
                        "Moved",
                        "Moved",
                        "Moved",
                        "StepAdvanced");
        double met = events.getFirst().time();
        assertThat(met).isEqualTo(0.02, within(1e-12));
        assertThat(events.subList(0, 6)).allMatch(e -> e.time() == met);
        assertThat(events.subList(6, 10)).allMatch(e -> e.time() == world.time());
        assertThat(events.get(3)).isEqualTo(new WorldEvent.ObjectAdded(met, 3, new Vec3(50, 0, 0)));
    }

    @Test
    void listenersHearWhenTheStepIsOver() {
        World world = pitch();
        List<Integer> seen = new ArrayList<>();
        world.addListener(event -> seen.add(world.objects().size()));

        world.advanceTimestep();

        assertThat(seen).hasSize(10).containsOnly(3);
    }

    @Test
    void whatAListenerDoesIsToldAfterwardsToAll() {
        World world = World.builder().add(Balls.at("A", 0)).build();
        List<String> first = new ArrayList<>();
        List<String> second = new ArrayList<>();
        world.addListener(
                event -> {
                    first.add(event.getClass().getSimpleName());
                    if (event instanceof WorldEvent.StepAdvanced) {
                        world.remove(1);
                    }
                });
        world.addListener(event -> second.add(event.getClass().getSimpleName()));

        world.advanceTimestep();

        assertThat(second)
                .isEqualTo(first)
                .containsExactly("Moved", "StepAdvanced", "EntityRemoved");
    }

    @Test
    void outsideAStepEventsAreToldAtOnce() {
        World world = World.builder().build();
        List<WorldEvent> events = new ArrayList<>();
        world.addListener(events::add);

        world.add(Balls.at("A", 7));
        world.remove(1);

        assertThat(events)
                .containsExactly(
                        new WorldEvent.EntityAdded(0, 1),
                        new WorldEvent.ObjectAdded(0, 1, new Vec3(7, 0, 0)),
                        new WorldEvent.EntityRemoved(0, 1));
    }

    @Test
    void aListenerThatIsRemovedHearsNothingMore() {
        World world = World.builder().add(Balls.at("A", 0)).build();
        List<WorldEvent> events = new ArrayList<>();
        WorldListener listener = events::add;
        world.addListener(listener);
        world.advanceTimestep();
        int before = events.size();

        world.removeListener(listener);
        world.advanceTimestep();

        assertThat(events).hasSize(before);
    }

    @Test
    void aFixedBodyIsNotToldToMoveAndStays() {
        World world =
                World.builder()
                        .add(Balls.ball("Rock").fixed().response(new ImpulseResponse()).build())
                        .add(Balls.ball("Hail").position(1.02, 0, 0).velocity(-9, 0, 0).build())
                        .build();
        List<WorldEvent> events = new ArrayList<>();
        world.addListener(events::add);

        world.advanceTimestep();
        world.advanceTimestep();

        assertThat(events).filteredOn(e -> e instanceof WorldEvent.Collided).hasSize(1);
        assertThat(events)
                .filteredOn(e -> e instanceof WorldEvent.Moved)
                .allMatch(e -> ((WorldEvent.Moved) e).objectId() == 2);
        assertThat(world.object("Rock").position()).isEqualTo(Vec3.ZERO);
        assertThat(world.object("Rock").linearMomentum()).isEqualTo(Vec3.ZERO);
        assertThat(world.object("Hail").velocity().x()).isPositive();
    }
}
