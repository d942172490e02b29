package org.auvsim.core.entity;

import org.auvsim.core.math.Vec3;

/**
 * Force and torque on a rigid body.
 *
 * @param force (N, world)
 * @param torque about the body's origin (N m, world)
 */
public record Wrench(Vec3 force, Vec3 torque) {
    /** Neither force nor torque. */
    public static final Wrench ZERO = new Wrench(Vec3.ZERO, Vec3.ZERO);
}
