package org.auvsim.auvsml.message.feedback;

import org.auvsim.core.description.Unit;
import org.auvsim.core.math.Vec3;

import java.util.Optional;

/**
 * A robot's velocity differs from that of its world object.
 *
 * @param timestamp the world's time at which the actual velocity was true
 * @param handlerName the feedback processor to use; the server may choose another
 * @param frame the axes of the velocities; else the world's
 * @param actualVelocity the robot's, over ground
 * @param actualAngularVelocity the robot's, if it measures that, too
 */
public record DifferentVelocityFeedbackMessage(
        long worldObjectId,
        @Unit("s") double timestamp,
        String handlerName,
        Optional<MeasurementFrame> frame,
        @Unit("m/s") Vec3 actualVelocity,
        @Unit("rad/s") Optional<Vec3> actualAngularVelocity)
        implements FeedbackMessage {
    @Override
    public Measurement measurement() {
        return new Measurement(
                frame.orElse(MeasurementFrame.WORLD),
                Optional.empty(),
                Optional.empty(),
                Optional.of(actualVelocity),
                actualAngularVelocity,
                Optional.empty());
    }
}
