package org.auvsim.auvsml.message.feedback;

import org.auvsim.auvsml.message.Message;
import org.auvsim.core.description.Unit;

import java.util.List;

/**
 * A feedback processor used a client's feedback.
 *
 * @param handlerName the processor
 * @param errorBefore distance of the object from the measured position before
 * @param errorAfter the same distance after
 * @param overlap what the object shares space with now: no collision is looked for when it is put
 *     somewhere
 */
public record FeedbackAppliedNotification(
        long worldObjectId,
        @Unit("s") double timestamp,
        String handlerName,
        @Unit("m") double errorBefore,
        @Unit("m") double errorAfter,
        List<OverlappedEntity> overlap)
        implements Message {}
