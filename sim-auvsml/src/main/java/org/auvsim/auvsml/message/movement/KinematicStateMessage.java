package org.auvsim.auvsml.message.movement;

import org.auvsim.auvsml.message.Message;
import org.auvsim.core.description.Unit;
import org.auvsim.core.math.Quat;
import org.auvsim.core.math.Vec3;

/**
 * Place and velocities of a world object after a step. Momenta contain the share of the water that
 * moves along; these velocities do not.
 *
 * @param quaternion the orientation, body to world
 * @param velocity of the object's origin, world axes
 * @param angularVelocity world axes
 * @param bodyVelocity of the object's origin, body axes
 * @param bodyAngularVelocity body axes
 */
public record KinematicStateMessage(
        @Unit("s") double timestamp,
        long worldObjectId,
        @Unit("m") Vec3 position,
        Quat quaternion,
        @Unit("m/s") Vec3 velocity,
        @Unit("rad/s") Vec3 angularVelocity,
        @Unit("m/s") Vec3 bodyVelocity,
        @Unit("rad/s") Vec3 bodyAngularVelocity)
        implements Message {}
