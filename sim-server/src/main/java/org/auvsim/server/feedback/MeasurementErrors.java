package org.auvsim.server.feedback;

import java.util.OptionalDouble;

/**
 * How far an object is from where it ought to be; each part is there if it was measured.
 *
 * @param position distance (m)
 * @param angle between the orientations (rad)
 * @param velocity length of the difference (m/s)
 * @param angularVelocity length of the difference (rad/s)
 */
public record MeasurementErrors(
        OptionalDouble position,
        OptionalDouble angle,
        OptionalDouble velocity,
        OptionalDouble angularVelocity) {}
