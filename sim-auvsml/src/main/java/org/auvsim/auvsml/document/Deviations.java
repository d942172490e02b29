package org.auvsim.auvsml.document;

import org.auvsim.core.description.Unit;
import org.auvsim.core.entity.Domain;

/**
 * Standard deviations of the errors of a body's motion, of each axis alone.
 *
 * @param angle of each component of the rotation vector
 */
public record Deviations(
        @Unit("m") double position,
        @Unit("rad") double angle,
        @Unit("m/s") double velocity,
        @Unit("rad/s") double angularVelocity) {
    /**
     * Checked deviations.
     *
     * @throws IllegalArgumentException if one is not above 0 and finite
     */
    public Deviations {
        Domain.above0("standard deviations", "position", position, "m");
        Domain.above0("standard deviations", "angle", angle, "rad");
        Domain.above0("standard deviations", "velocity", velocity, "m/s");
        Domain.above0("standard deviations", "angular velocity", angularVelocity, "rad/s");
    }
}
