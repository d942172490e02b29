package org.auvsim.core.entity;

import org.auvsim.core.math.Vec3;

/**
 * How a rigid body moves at an instant.
 *
 * @param velocity of the origin (m/s, world)
 * @param angularVelocity (rad/s, world)
 */
public record Twist(Vec3 velocity, Vec3 angularVelocity) {}
