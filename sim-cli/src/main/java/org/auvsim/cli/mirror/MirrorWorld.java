package org.auvsim.cli.mirror;

import org.auvsim.core.entity.WorldObject;
import org.auvsim.core.world.World;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;

/** A world of our own, some of whose objects stand for a server's of the same name. */
public final class MirrorWorld {
    /** Times (s) this close are one: they are sums of steps, which round. */
    static final double SAME_TIME = 1e-9;

    private final World world;
    private final Map<Long, WorldObject> images = new TreeMap<>();

    /** A mirror of a server's objects, by their ids and names; others are left out. */
    public MirrorWorld(World world, Map<Long, String> served) {
        this.world = world;
        for (WorldObject own : world.objects()) {
            served.forEach(
                    (id, name) -> {
                        if (name.equals(own.name())) {
                            images.put(id, own);
                        }
                    });
        }
    }

    /** Names of the objects that both have, in the order of the server's ids. */
    public List<String> common() {
        return images.values().stream().map(WorldObject::name).toList();
    }

    /** The server's ids of the objects that both have and that can move here, in order. */
    public List<Long> movable() {
        return images.entrySet().stream()
                .filter(image -> !image.getValue().isFixed())
                .map(Map.Entry::getKey)
                .toList();
    }

    /** Lets time go on to a time (s), in steps of its own or shorter; never back. */
    void advanceTo(double time) {
        double left = time - world.time();
        while (left > SAME_TIME) {
            world.advanceTimestep(Math.min(world.timeStep(), left));
            left = time - world.time();
        }
    }

    /** The object here that stands for one of the server's. */
    Optional<WorldObject> image(long servedId) {
        return Optional.ofNullable(images.get(servedId));
    }
}
