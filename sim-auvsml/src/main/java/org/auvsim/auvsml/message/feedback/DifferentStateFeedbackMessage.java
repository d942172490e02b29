package org.auvsim.auvsml.message.feedback;

import org.auvsim.core.description.Unit;
import org.auvsim.core.math.Quat;
import org.auvsim.core.math.Vec3;

import java.util.Optional;

/**
 * A robot's motion differs from that of its world object: any part of it that was measured, and how
 * far the measurement may be off.
 *
 * @param timestamp the world's time at which all of it was true
 * @param handlerName the feedback processor to use; the server may choose another
 * @param frame the axes of all of it; else the world's
 * @param position where the robot is
 * @param orientation the robot's: a quaternion of length 1, body to frame
 * @param velocity the robot's, over ground
 * @param angularVelocity the robot's
 * @param covariance of the errors of what is stated, in the order position, rotation vector,
 *     velocity, angular velocity: three rows each
 */
public record DifferentStateFeedbackMessage(
        long worldObjectId,
        @Unit("s") double timestamp,
        String handlerName,
        Optional<MeasurementFrame> frame,
        @Unit("m") Optional<Vec3> position,
        Optional<Quat> orientation,
        @Unit("m/s") Optional<Vec3> velocity,
        @Unit("rad/s") Optional<Vec3> angularVelocity,
        Optional<Covariance> covariance)
        implements FeedbackMessage {
    /**
     * A checked message.
     *
     * @throws IllegalArgumentException if nothing is stated, the orientation has not nearly length
     *     1 or the covariance another size than what is stated
     */
    public DifferentStateFeedbackMessage {
        orientation =
                new Measurement(
                                MeasurementFrame.WORLD,
                                position,
                                orientation,
                                velocity,
                                angularVelocity,
                                covariance)
                        .orientation();
    }

    @Override
    public Measurement measurement() {
        return new Measurement(
                frame.orElse(MeasurementFrame.WORLD),
                position,
                orientation,
                velocity,
                angularVelocity,
                covariance);
    }
}
