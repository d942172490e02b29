package org.auvsim.examples.mine;

import org.auvsim.core.entity.Change;
import org.auvsim.core.entity.Collidable;
import org.auvsim.core.entity.CollisionResponse;
import org.auvsim.core.entity.Contact;
import org.auvsim.core.entity.Participant;
import org.auvsim.core.math.Vec3;
import org.auvsim.core.volume.Sphere;
import org.auvsim.core.volume.Volume;

import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;

/**
 * A ball that grows at a constant speed. What its front meets, it pushes away and damages, once
 * each, by the square of the distance; then it is over.
 *
 * @param source what it came from, with its strength
 * @param centre (m, world)
 * @param start when it had its first radius (s)
 * @param met ids of those whom it has met
 */
public record ShockWave(
        long id, String name, Mine source, Vec3 centre, double start, List<Long> met)
        implements Collidable {
    /** A wave that has met these. */
    public ShockWave {
        met = List.copyOf(met);
    }

    /** Radius of the front (m) at a time (s), up to its reach. */
    public double radius(double time) {
        double grown = source.core() + source.speed() * Math.max(0, time - start);
        return Math.min(grown, source.reach());
    }

    @Override
    public Vec3 positionAt(double time) {
        return centre;
    }

    @Override
    public Volume volumeAt(double time) {
        return new Sphere(radius(time));
    }

    @Override
    public boolean meets(Collidable other) {
        return !met.contains(other.id());
    }

    @Override
    public boolean isOver(double time) {
        return radius(time) >= source.reach();
    }

    @Override
    public Optional<CollisionResponse> response() {
        return Optional.of(this::strike);
    }

    private List<Change> strike(Contact contact) {
        Participant other = contact.other();
        Vec3 place = other.body().orElseThrow().state().position();
        double radius = radius(contact.time());
        double share = 1 / (radius * radius);
        // The contact's normal leads from the other one to the wave.
        Vec3 push = contact.normal().times(-source.impulse() * share);
        Vec3 turn = contact.point().minus(place).cross(push);
        return List.of(
                new Change.Momentum(other.id(), push, turn),
                new Change.UpdateComponents<>(
                        other.id(), Hull.class, hull -> hull.damaged(source.damage() * share)),
                new Change.Update<>(id, ShockWave.class, wave -> wave.having(other.id())));
    }

    private ShockWave having(long other) {
        List<Long> all = Stream.concat(met.stream(), Stream.of(other)).toList();
        return new ShockWave(id, name, source, centre, start, all);
    }
}
