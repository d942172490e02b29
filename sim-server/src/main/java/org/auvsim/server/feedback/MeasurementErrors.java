package org.auvsim.server.feedback;

import org.auvsim.auvsml.ErrorCode;
import org.auvsim.auvsml.message.command.RefusedException;

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
        OptionalDouble angularVelocity) {
    /** Corrections larger than these (m; m/s and rad/s) are taken for faults of what measures. */
    private static final double FARTHEST = 1e9;

    private static final double FASTEST = 1e6;

    /**
     * Nothing if an object can be corrected by so much.
     *
     * @throws RefusedException if that is too far or too fast to be simulated
     */
    void requirePossible(String object) {
        require(object, position, FARTHEST, "m away from");
        require(object, velocity, FASTEST, "m/s beside");
        require(object, angularVelocity, FASTEST, "rad/s beside");
    }

    private static void require(String object, OptionalDouble error, double most, String what) {
        if (error.isPresent() && !(error.getAsDouble() <= most)) {
            throw new RefusedException(
                    ErrorCode.INVALID_VALUE,
                    "'%s' was measured more than %s %s what the model has; that is not used"
                            .formatted(object, most, what));
        }
    }
}
