package org.auvsim.auvsml.message.feedback;

import org.auvsim.core.description.Unit;
import org.auvsim.core.math.Quat;

import java.util.Optional;

/**
 * A robot's orientation differs from that of its world object.
 *
 * @param timestamp the world's time at which the actual orientation was true
 * @param handlerName the feedback processor to use; the server may choose another
 * @param frame the axes of the orientation; else the world's
 * @param actualOrientation the robot's: a quaternion of length 1, body to frame
 */
public record DifferentOrientationFeedbackMessage(
        long worldObjectId,
        @Unit("s") double timestamp,
        String handlerName,
        Optional<MeasurementFrame> frame,
        Quat actualOrientation)
        implements FeedbackMessage {
    /**
     * A checked message.
     *
     * @throws IllegalArgumentException if the orientation has not nearly length 1
     */
    public DifferentOrientationFeedbackMessage {
        actualOrientation = Measurement.unit(actualOrientation);
    }

    @Override
    public Measurement measurement() {
        return new Measurement(
                frame.orElse(MeasurementFrame.WORLD),
                Optional.empty(),
                Optional.of(actualOrientation),
                Optional.empty(),
                Optional.empty(),
                Optional.empty());
    }
}
