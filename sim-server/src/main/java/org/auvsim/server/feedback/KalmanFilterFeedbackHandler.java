package org.auvsim.server.feedback;

import org.apache.commons.math3.linear.MatrixUtils;
import org.apache.commons.math3.linear.RealMatrix;
import org.auvsim.auvsml.document.Deviations;
import org.auvsim.core.entity.Domain;

import java.util.Arrays;

/**
 * An extended Kalman filter on the motion of a rigid body: weighs what was measured against the
 * model, each by how far it may be off, and corrects all of the motion, also what was not measured.
 *
 * <p>Its estimate is the object itself. Beside it, it remembers the covariance of twelve errors:
 * position, rotation vector, velocity, angular velocity. The world's steps carry them on: by
 * central differences through the real step that is corrected, whose power stands for all steps
 * since the last measurement; white accelerations, which the model does not know, add to them. A
 * measurement without a covariance of its own has that of {@code measurement}.
 *
 * @param acceleration square root of the spectral density of the model's error (m/s^2 / sqrt(Hz))
 * @param angularAcceleration likewise of turns (rad/s^2 / sqrt(Hz))
 * @param measurement how far a measurement may be off that does not say so
 * @param initial how far the object may be off at the first measurement
 */
public record KalmanFilterFeedbackHandler(
        double acceleration, double angularAcceleration, Deviations measurement, Deviations initial)
        implements FeedbackProcessor {
    /**
     * A checked filter.
     *
     * @throws IllegalArgumentException if a density is negative or not finite
     */
    public KalmanFilterFeedbackHandler {
        Domain.atLeast0("a Kalman filter", "acceleration", acceleration, "m/s^2/sqrt(Hz)");
        Domain.atLeast0(
                "a Kalman filter", "angular acceleration", angularAcceleration, "rad/s^2/sqrt(Hz)");
    }

    /** For a small vehicle with acoustic positions, a compass, a DVL and a gyroscope. */
    public KalmanFilterFeedbackHandler() {
        this(0.1, 0.1, new Deviations(0.1, 0.02, 0.05, 0.01), new Deviations(1, 0.2, 0.5, 0.1));
    }

    @Override
    public Phase phase() {
        return Phase.AFTER_STEP;
    }

    @Override
    public boolean looksBack() {
        return true;
    }

    @Override
    public void process(Correction correction) {
        Target target = correction.target();
        RealMatrix noise =
                target.covariance()
                        .orElseGet(() -> KalmanUpdate.measured(target, covariance(measurement)));
        KalmanUpdate update =
                KalmanUpdate.of(
                        RigidMotion.of(correction.object()), predicted(correction), target, noise);
        update.motion().giveTo(correction.object());
        correction.remember(
                new FilterMemory(correction.time(), update.covariance(), update.surprise()));
    }

    /** The covariance of the object's errors now, before the measurement. */
    private RealMatrix predicted(Correction correction) {
        return correction
                .memory(FilterMemory.class)
                .filter(memory -> memory.time() <= correction.time())
                .map(memory -> carried(memory, correction))
                .filter(Covariances::isFinite)
                .orElseGet(() -> covariance(initial));
    }

    /** The variances on the diagonal, three of each. */
    private static RealMatrix covariance(Deviations of) {
        double[] deviations = {of.position(), of.angle(), of.velocity(), of.angularVelocity()};
        double[] variances = new double[RigidMotion.SIZE];
        Arrays.setAll(variances, i -> deviations[i / 3] * deviations[i / 3]);
        return MatrixUtils.createRealDiagonalMatrix(variances);
    }

    private RealMatrix carried(FilterMemory memory, Correction correction) {
        double gap = correction.time() - memory.time();
        if (gap <= CorrectiveFeedbackSystem.SAME_TIME) {
            return memory.covariance();
        }
        double duration = correction.duration();
        boolean isStep = duration > CorrectiveFeedbackSystem.SAME_TIME; // else a collision alone
        long steps = isStep ? Math.max(1, Math.round(gap / duration)) : 1;
        RealMatrix noise = StepTransition.noise(gap / steps, acceleration, angularAcceleration);
        return StepTransition.of(correction, noise).repeated(steps).carry(memory.covariance());
    }
}
