package org.auvsim.core.entity;

import org.auvsim.core.math.Vec3;

/**
 * What a collision response may know of a rigid body, at the instant of contact.
 *
 * @param state position, orientation and momenta
 * @param velocity of the origin (m/s, world)
 * @param angularVelocity (rad/s, world)
 * @param mobility the inverse of its inertia, world axes
 * @param restitution share of the approach speed that is left after a bounce, 0 to 1
 * @param friction coefficient of Coulomb friction, 0 or more
 */
public record BodyMotion(
        MovementState state,
        Vec3 velocity,
        Vec3 angularVelocity,
        Mobility mobility,
        double restitution,
        double friction) {
    /** Velocity (m/s, world) of the body's material at a point (m, world). */
    public Vec3 velocityAt(Vec3 point) {
        return velocity.plus(angularVelocity.cross(point.minus(state.position())));
    }
}
