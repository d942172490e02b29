package org.auvsim.server.feedback;

import org.auvsim.auvsml.message.feedback.FeedbackAppliedNotification;
import org.auvsim.auvsml.message.feedback.OverlappedEntity;

import java.util.List;

/**
 * A correction that was made.
 *
 * @param time of the world (s)
 * @param processor the name of the processor
 * @param before how far the object is from where it ought to be, without the correction
 * @param after the same with it
 * @param target where it ought to be by what was measured
 * @param converged whether the processor reached what it aimed at
 * @param overlaps ids of what the object shares space with now
 */
public record AppliedFeedback(
        long objectId,
        double time,
        String processor,
        MeasurementErrors before,
        MeasurementErrors after,
        Target target,
        boolean converged,
        List<Long> overlaps) {
    /** What clients are told of it. */
    public FeedbackAppliedNotification notification() {
        return new FeedbackAppliedNotification(
                objectId,
                time,
                processor,
                target.position(),
                before.position(),
                after.position(),
                before.angle(),
                after.angle(),
                before.velocity(),
                after.velocity(),
                before.angularVelocity(),
                after.angularVelocity(),
                converged,
                overlaps.stream().map(OverlappedEntity::new).toList());
    }
}
