package org.auvsim.junit;

import org.auvsim.core.entity.WorldObject;
import org.auvsim.core.world.World;
import org.auvsim.core.world.WorldEvent;
import org.auvsim.core.world.WorldListener;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.SortedMap;
import java.util.TreeMap;

/** Watches a world from the time on at which it is made. */
final class Observation implements WorldListener {
    private final World world;
    private final SortedMap<Long, Seen> bodies = new TreeMap<>();
    private final List<Encounter> encounters = new ArrayList<>();

    private record Seen(String name, List<Sample> samples) {}

    Observation(World world) {
        this.world = world;
        world.addListener(this);
        look();
    }

    @Override
    public void happened(WorldEvent event) {
        switch (event) {
            case WorldEvent.Collided collided -> encounters.add(Encounter.of(collided));
            case WorldEvent.StepAdvanced _ -> look();
            default -> {}
        }
    }

    private void look() {
        for (WorldObject object : world.objects()) {
            List<Sample> of =
                    bodies.computeIfAbsent(
                                    object.id(), _ -> new Seen(object.name(), new ArrayList<>()))
                            .samples();
            if (isStale(of, object)) {
                of.removeLast();
            }
            of.add(sample(object));
        }
    }

    /** A state at the same time is newer; of what is fixed the first and the last are enough. */
    private boolean isStale(List<Sample> before, WorldObject object) {
        return !before.isEmpty()
                && (before.getLast().time() >= world.time()
                        || (object.isFixed() && before.size() > 1));
    }

    private Sample sample(WorldObject object) {
        return new Sample(
                world.time(),
                object.position(),
                object.orientation(),
                object.velocity(),
                object.angularVelocity());
    }

    List<Encounter> encounters() {
        return List.copyOf(encounters);
    }

    /** What was seen, with what a recording has of it. */
    List<Track> tracks(Map<Long, List<Pose>> recorded) {
        return bodies.entrySet().stream()
                .map(
                        body ->
                                new Track(
                                        body.getKey(),
                                        body.getValue().name(),
                                        body.getValue().samples(),
                                        recorded.getOrDefault(body.getKey(), List.of())))
                .toList();
    }
}
