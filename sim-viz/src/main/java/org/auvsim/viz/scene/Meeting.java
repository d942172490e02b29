package org.auvsim.viz.scene;

import org.auvsim.core.math.Vec3;

/**
 * Two entities met.
 *
 * @param time (s)
 * @param point where they touched (m, world)
 * @param impulse on the first (N s, world)
 */
public record Meeting(double time, long one, long other, Vec3 point, Vec3 impulse) {}
