package org.auvsim.auvsml.message.movement;

import org.auvsim.auvsml.message.Message;
import org.auvsim.core.description.Unit;
import org.auvsim.core.entity.Contact;
import org.auvsim.core.math.Vec3;
import org.auvsim.core.step.Collision;

/**
 * Two entities met and responded.
 *
 * @param point where they touched, world axes
 * @param normal of length 1, out of the other one's surface
 * @param impulse that the entity received; the other one received its opposite
 */
public record CollisionNotification(
        @Unit("s") double timestamp,
        long entityId,
        long otherId,
        @Unit("m") Vec3 point,
        Vec3 normal,
        @Unit("N s") Vec3 impulse)
        implements Message {
    /** The message on a collision at this time (s). */
    public static CollisionNotification of(double timestamp, Collision collision) {
        Contact contact = collision.contact();
        return new CollisionNotification(
                timestamp,
                contact.self().id(),
                contact.other().id(),
                contact.point(),
                contact.normal(),
                collision.impulse());
    }
}
