package org.auvsim.junit;

import org.auvsim.core.math.Vec3;
import org.auvsim.core.world.WorldEvent;

/**
 * A collision.
 *
 * @param time world time (s)
 * @param id of one of the two
 * @param name its name
 * @param otherId of the other one
 * @param otherName its name
 * @param point where they touched (m, world)
 * @param impulse that the first one received (N s, world); the other one received its opposite
 */
public record Encounter(
        double time,
        long id,
        String name,
        long otherId,
        String otherName,
        Vec3 point,
        Vec3 impulse) {
    static Encounter of(WorldEvent.Collided event) {
        var contact = event.collision().contact();
        return new Encounter(
                event.time(),
                contact.self().id(),
                contact.self().name(),
                contact.other().id(),
                contact.other().name(),
                contact.point(),
                event.collision().impulse());
    }

    boolean involves(long bodyId) {
        return id == bodyId || otherId == bodyId;
    }

    /** The name of the one that a body met. */
    String partner(long bodyId) {
        return id == bodyId ? otherName : name;
    }
}
