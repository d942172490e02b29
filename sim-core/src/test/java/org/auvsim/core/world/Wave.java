package org.auvsim.core.world;

import org.auvsim.core.entity.Change;
import org.auvsim.core.entity.Collidable;
import org.auvsim.core.entity.CollisionResponse;
import org.auvsim.core.math.Vec3;
import org.auvsim.core.volume.Sphere;
import org.auvsim.core.volume.Volume;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/**
 * An expanding ball that remembers whom it has met, and pushes nobody.
 *
 * @param speed of its front (m/s)
 * @param last when it is over (s)
 */
record Wave(long id, String name, double start, double speed, double last, List<Long> met)
        implements Collidable {
    Wave {
        met = List.copyOf(met);
    }

    static Wave at(long id, double start) {
        return new Wave(id, "Wave " + id, start, 10, start + 1, List.of());
    }

    @Override
    public Vec3 positionAt(double time) {
        return Vec3.ZERO;
    }

    @Override
    public Volume volumeAt(double time) {
        return new Sphere(0.1 + speed * Math.max(0, time - start));
    }

    @Override
    public boolean meets(Collidable other) {
        return !met.contains(other.id());
    }

    @Override
    public boolean isOver(double time) {
        return time > last;
    }

    @Override
    public Optional<CollisionResponse> response() {
        return Optional.of(
                contact ->
                        List.of(
                                new Change.Update<>(
                                        id, Wave.class, wave -> wave.met(contact.other().id()))));
    }

    private Wave met(long other) {
        List<Long> all = new ArrayList<>(met);
        all.add(other);
        return new Wave(id, name, start, speed, last, all);
    }
}
