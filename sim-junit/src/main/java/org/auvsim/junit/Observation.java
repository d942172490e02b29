package org.auvsim.junit;

import org.auvsim.core.entity.WorldObject;
import org.auvsim.core.world.World;
import org.auvsim.core.world.WorldEvent;
import org.auvsim.core.world.WorldListener;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.function.LongFunction;

/**
 * Watches a world from the time on at which it is made. Where late feedback has steps made again,
 * what was seen of the past stays; where a client goes back to an earlier state, it is forgotten.
 */
final class Observation implements WorldListener {
    private final World world;
    private final SortedMap<Long, Seen> bodies = new TreeMap<>();
    private final List<Encounter> encounters = new ArrayList<>();
    private final List<Encounter> sinceLook = new ArrayList<>();
    private double lookedAt;

    private record Seen(String name, List<Sample> samples) {}

    Observation(World world) {
        this.world = world;
        this.lookedAt = world.time();
        world.addListener(this);
        look();
    }

    @Override
    public void happened(WorldEvent event) {
        if (event instanceof WorldEvent.Collided collided) {
            sinceLook.add(Encounter.of(collided));
        }
    }

    /** Looks where the bodies are; called after each step. */
    void look() {
        lookAtCollisions();
        for (WorldObject object : world.objects()) {
            look(object);
        }
        lookedAt = world.time();
    }

    private void lookAtCollisions() {
        double now = world.time();
        if (now < lookedAt) {
            encounters.removeIf(seen -> seen.time() > now);
        } else {
            // those of a step that was made again
            sinceLook.removeIf(again -> again.time() < lookedAt - Trajectory.SAME_TIME);
        }
        encounters.addAll(sinceLook);
        sinceLook.clear();
    }

    private void look(WorldObject object) {
        List<Sample> samples =
                bodies.computeIfAbsent(object.id(), _ -> new Seen(object.name(), new ArrayList<>()))
                        .samples();
        while (!samples.isEmpty() && samples.getLast().time() >= world.time()) {
            samples.removeLast();
        }
        if (object.isFixed() && samples.size() > 1) {
            samples.removeLast();
        }
        samples.add(sample(object));
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

    /** What was seen, with where a recording has the body of an id. */
    List<Track> tracks(LongFunction<Optional<List<Pose>>> recorded) {
        return bodies.entrySet().stream()
                .map(
                        body ->
                                new Track(
                                        body.getKey(),
                                        body.getValue().name(),
                                        body.getValue().samples(),
                                        recorded.apply(body.getKey())))
                .toList();
    }
}
