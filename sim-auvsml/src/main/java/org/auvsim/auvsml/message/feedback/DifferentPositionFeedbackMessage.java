package org.auvsim.auvsml.message.feedback;

import org.auvsim.core.description.Unit;
import org.auvsim.core.math.Vec3;

import java.util.Optional;

/**
 * A robot's position differs from that of its world object (thesis, appendix A.3).
 *
 * @param timestamp the world's time at which the actual position was true
 * @param handlerName the feedback processor to use; the server may choose another
 * @param frame the axes of the positions; else the world's
 * @param virtualPosition where the simulator had the object
 * @param actualPosition where the robot is
 * @param oldPosition where the robot was at the snapshot before
 */
public record DifferentPositionFeedbackMessage(
        long worldObjectId,
        @Unit("s") double timestamp,
        String handlerName,
        Optional<MeasurementFrame> frame,
        @Unit("m") Vec3 virtualPosition,
        @Unit("m") Vec3 actualPosition,
        @Unit("m") Vec3 oldPosition)
        implements FeedbackMessage {
    /** In the world's axes, as the thesis has it. */
    public DifferentPositionFeedbackMessage(
            long worldObjectId,
            double timestamp,
            String handlerName,
            Vec3 virtualPosition,
            Vec3 actualPosition,
            Vec3 oldPosition) {
        this(
                worldObjectId,
                timestamp,
                handlerName,
                Optional.empty(),
                virtualPosition,
                actualPosition,
                oldPosition);
    }

    @Override
    public Measurement measurement() {
        return new Measurement(
                frame.orElse(MeasurementFrame.WORLD),
                Optional.of(actualPosition),
                Optional.empty(),
                Optional.empty(),
                Optional.empty(),
                Optional.empty());
    }
}
