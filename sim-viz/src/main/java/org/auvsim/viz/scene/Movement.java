package org.auvsim.viz.scene;

import org.auvsim.core.math.Quat;
import org.auvsim.core.math.Vec3;

/**
 * How an object moves at an instant.
 *
 * @param time (s)
 * @param position of its origin (m, world)
 * @param orientation body to world
 * @param velocity of its origin (m/s, world)
 * @param angularVelocity (rad/s, world)
 */
public record Movement(
        double time, Vec3 position, Quat orientation, Vec3 velocity, Vec3 angularVelocity) {}
