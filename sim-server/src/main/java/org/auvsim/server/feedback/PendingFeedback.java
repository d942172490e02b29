package org.auvsim.server.feedback;

import org.auvsim.auvsml.message.feedback.DifferentPositionFeedbackMessage;

/** A feedback that was accepted and waits for its processor. */
record PendingFeedback(
        FeedbackSender sender,
        DifferentPositionFeedbackMessage message,
        FeedbackProcessor processor) {}
