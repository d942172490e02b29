package org.auvsim.auvsml.message.feedback;

import org.auvsim.auvsml.message.Message;
import org.auvsim.core.description.Unit;
import org.auvsim.core.math.Vec3;

import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;

/**
 * What a feedback processor made of a client's feedback. Errors are those against what was
 * measured, each there if that part was: without the correction and with it.
 *
 * @param handlerName the processor
 * @param measuredPosition where the object was measured, in the world's axes, at the timestamp: the
 *     model's own motion is added to a measurement from within the step; there if a position was
 *     measured
 * @param errorBefore distance of the object from the measured position before
 * @param errorAfter the same distance after
 * @param angleErrorBefore angle to the measured orientation before
 * @param angleErrorAfter the same angle after
 * @param velocityErrorBefore difference to the measured velocity before
 * @param velocityErrorAfter the same difference after
 * @param angularVelocityErrorBefore difference to the measured angular velocity before
 * @param angularVelocityErrorAfter the same difference after
 * @param converged whether the processor reached what it aimed at
 * @param overlap what the object shares space with now: no collision is looked for when it is put
 *     somewhere
 */
public record FeedbackAppliedNotification(
        long worldObjectId,
        @Unit("s") double timestamp,
        String handlerName,
        @Unit("m") Optional<Vec3> measuredPosition,
        @Unit("m") OptionalDouble errorBefore,
        @Unit("m") OptionalDouble errorAfter,
        @Unit("rad") OptionalDouble angleErrorBefore,
        @Unit("rad") OptionalDouble angleErrorAfter,
        @Unit("m/s") OptionalDouble velocityErrorBefore,
        @Unit("m/s") OptionalDouble velocityErrorAfter,
        @Unit("rad/s") OptionalDouble angularVelocityErrorBefore,
        @Unit("rad/s") OptionalDouble angularVelocityErrorAfter,
        boolean converged,
        List<OverlappedEntity> overlap)
        implements Message {}
