package org.auvsim.experiments.live;

import org.auvsim.core.math.Vec3;

/**
 * A robot that takes part.
 *
 * @param objectId of its world object
 * @param start where that is at the beginning (m)
 */
public record Participant(long objectId, Vec3 start, Robot robot) {}
