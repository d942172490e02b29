package org.auvsim.auvsml.document;

import org.auvsim.core.description.Default;
import org.auvsim.core.description.Unit;
import org.auvsim.core.entity.Domain;

/**
 * How one of the server's feedback processors is to work in a scenario, in place of its defaults;
 * here it is data alone.
 */
public interface FeedbackProcessing {
    /**
     * Forces and torques through the step.
     *
     * @param momentum what becomes of the velocity
     */
    record VectorAdjustmentFeedbackHandler(@Default("projected") MomentumRule momentum)
            implements FeedbackProcessing {}

    /**
     * An extended Kalman filter.
     *
     * @param acceleration square root of the spectral density of the model's error
     * @param angularAcceleration likewise of turns
     * @param measurement how far a measurement may be off that does not say so
     * @param initial how far the object may be off at the first measurement
     */
    record KalmanFilterFeedbackHandler(
            @Unit("m/s^2/sqrt(Hz)") @Default("0.1") double acceleration,
            @Unit("rad/s^2/sqrt(Hz)") @Default("0.1") double angularAcceleration,
            @Default("0.1 0.02 0.05 0.01") Deviations measurement,
            @Default("1 0.2 0.5 0.1") Deviations initial)
            implements FeedbackProcessing {
        /**
         * A checked filter.
         *
         * @throws IllegalArgumentException if a density is negative or not finite
         */
        public KalmanFilterFeedbackHandler {
            Domain.atLeast0("a Kalman filter", "acceleration", acceleration, "m/s^2/sqrt(Hz)");
            Domain.atLeast0(
                    "a Kalman filter",
                    "angular acceleration",
                    angularAcceleration,
                    "rad/s^2/sqrt(Hz)");
        }
    }
}
