package org.auvsim.auvsml.message.feedback;

import org.auvsim.auvsml.message.Message;
import org.auvsim.core.description.Unit;

/**
 * A feedback processor used a client's feedback.
 *
 * @param handlerName the processor
 * @param errorBefore distance of the object from the measured position before
 * @param errorAfter the same distance after
 */
public record FeedbackAppliedNotification(
        long worldObjectId,
        @Unit("s") double timestamp,
        String handlerName,
        @Unit("m") double errorBefore,
        @Unit("m") double errorAfter)
        implements Message {}
