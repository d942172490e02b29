package org.auvsim.core.entity;

import org.auvsim.core.math.Quat;
import org.auvsim.core.math.Vec3;

/**
 * How a rigid body moves at an instant (thesis, section 4.1); the immutable record that leaves the
 * world.
 *
 * @param position of the body's origin (m, world)
 * @param orientation unit quaternion, body to world
 * @param linearMomentum (kg m/s, world)
 * @param angularMomentum about the body's origin (kg m^2/s, world)
 */
public record MovementState(
        Vec3 position, Quat orientation, Vec3 linearMomentum, Vec3 angularMomentum) {}
