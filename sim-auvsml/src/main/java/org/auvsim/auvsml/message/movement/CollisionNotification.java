package org.auvsim.auvsml.message.movement;

import org.auvsim.auvsml.message.Message;
import org.auvsim.core.description.Unit;
import org.auvsim.core.math.Vec3;

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
        implements Message {}
