package org.auvsim.server.feedback;

import org.auvsim.core.entity.Domain;

/**
 * Standard deviations of the errors of a motion, of each axis alone.
 *
 * @param position (m)
 * @param angle (rad)
 * @param velocity (m/s)
 * @param angularVelocity (rad/s)
 */
public record Deviations(double position, double angle, double velocity, double angularVelocity) {
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

    /** The variances on the diagonal, three of each. */
    Matrix covariance() {
        double[] variances = new double[RigidMotion.SIZE];
        double[] deviations = {position, angle, velocity, angularVelocity};
        for (int i = 0; i < variances.length; i++) {
            variances[i] = deviations[i / 3] * deviations[i / 3];
        }
        return Matrix.diagonal(variances);
    }
}
