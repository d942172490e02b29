package org.auvsim.core.entity;

import org.auvsim.core.math.Vec3;

/**
 * Force and torque on a rigid body, in the world's axes unless stated otherwise.
 *
 * @param force (N)
 * @param torque about the body's origin (N m)
 */
public record Wrench(Vec3 force, Vec3 torque) {
    /** Neither force nor torque. */
    public static final Wrench ZERO = new Wrench(Vec3.ZERO, Vec3.ZERO);
}
