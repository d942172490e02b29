package org.auvsim.auvsml.message.feedback;

import org.auvsim.core.entity.Domain;
import org.auvsim.core.math.Quat;
import org.auvsim.core.math.Vec3;

import java.util.Optional;

/**
 * What a robot measured of its own motion at one instant.
 *
 * @param frame the axes of all that follows
 * @param position of the body's origin (m)
 * @param orientation unit quaternion, body to frame
 * @param velocity of the body's origin (m/s)
 * @param angularVelocity (rad/s)
 * @param covariance of the errors of what is there, in this order; of an orientation it is that of
 *     the rotation vector (rad) by which it may be off, in the frame's axes
 */
public record Measurement(
        MeasurementFrame frame,
        Optional<Vec3> position,
        Optional<Quat> orientation,
        Optional<Vec3> velocity,
        Optional<Vec3> angularVelocity,
        Optional<Covariance> covariance) {
    private static final double NEARLY = 1e-3;

    /**
     * A checked measurement.
     *
     * @throws IllegalArgumentException if nothing was measured, a number is not finite, the
     *     orientation has not length 1 or the covariance another size than what was measured
     */
    public Measurement {
        position.ifPresent(p -> Domain.finite("a measurement", "position", p, "m"));
        orientation = orientation.map(Measurement::unit);
        velocity.ifPresent(v -> Domain.finite("a measurement", "velocity", v, "m/s"));
        angularVelocity.ifPresent(
                w -> Domain.finite("a measurement", "angular velocity", w, "rad/s"));
        int size = size(position, orientation, velocity, angularVelocity);
        if (size == 0) {
            throw new IllegalArgumentException(
                    "a measurement must state a position, an orientation, a velocity or an angular"
                            + " velocity, but states none");
        }
        if (covariance.isPresent() && covariance.get().size() != size) {
            throw new IllegalArgumentException(
                    "the covariance of %d measured numbers must have %d rows of %d numbers,"
                                    .formatted(size, size, size)
                            + " but has %d".formatted(covariance.get().size()));
        }
    }

    /** How many numbers a covariance of it has on its diagonal. */
    public int size() {
        return size(position, orientation, velocity, angularVelocity);
    }

    private static int size(Optional<?>... parts) {
        int size = 0;
        for (Optional<?> part : parts) {
            size += part.isPresent() ? 3 : 0;
        }
        return size;
    }

    /**
     * An orientation scaled to length 1.
     *
     * @throws IllegalArgumentException if its length is not nearly 1
     */
    static Quat unit(Quat orientation) {
        if (!(Math.abs(orientation.norm() - 1) <= NEARLY)) {
            throw new IllegalArgumentException(
                    "an orientation must be a quaternion of length 1 (within %s), but"
                                    .formatted(NEARLY)
                            + " %s has the length %s".formatted(orientation, orientation.norm()));
        }
        return Domain.unit("a measurement", "orientation", orientation);
    }
}
