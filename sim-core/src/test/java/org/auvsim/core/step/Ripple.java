package org.auvsim.core.step;

import org.auvsim.core.entity.Change;
import org.auvsim.core.entity.Collidable;
import org.auvsim.core.entity.CollisionResponse;
import org.auvsim.core.math.Vec3;
import org.auvsim.core.volume.Sphere;
import org.auvsim.core.volume.Volume;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/** A wave from the origin at 0 s, whose front has this speed (m/s); it meets each object once. */
record Ripple(long id, double speed, List<Long> met) implements Collidable {
    @Override
    public String name() {
        return "Ripple " + id;
    }

    @Override
    public Vec3 positionAt(double time) {
        return Vec3.ZERO;
    }

    @Override
    public Volume volumeAt(double time) {
        return new Sphere(0.1 + speed * time);
    }

    @Override
    public boolean meets(Collidable other) {
        return !met.contains(other.id());
    }

    @Override
    public Optional<CollisionResponse> response() {
        return Optional.of(
                contact ->
                        List.of(
                                new Change.Update<>(
                                        id, Ripple.class, r -> r.met(contact.other().id()))));
    }

    private Ripple met(long other) {
        List<Long> all = new ArrayList<>(met);
        all.add(other);
        return new Ripple(id, speed, List.copyOf(all));
    }
}
