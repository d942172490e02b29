package org.auvsim.server.feedback;

import org.auvsim.auvsml.message.feedback.DifferentPositionFeedbackMessage;

import java.util.Comparator;

/** A feedback that was accepted and waits for its processor. */
record PendingFeedback(
        FeedbackSender sender,
        DifferentPositionFeedbackMessage message,
        FeedbackProcessor processor) {
    /** The order of use; a stable sort leaves equal ones as they arrived. */
    static final Comparator<PendingFeedback> ORDER =
            Comparator.<PendingFeedback>comparingLong(p -> p.message().worldObjectId())
                    .thenComparingDouble(p -> p.message().timestamp());
}
