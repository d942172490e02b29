package org.auvsim.server.feedback;

import org.auvsim.auvsml.message.feedback.FeedbackMessage;
import org.auvsim.core.entity.Domain;
import org.auvsim.server.feedback.FeedbackProcessor.Phase;

import java.util.Comparator;

/** A feedback that was accepted and waits for its processor. */
public record PendingFeedback(
        FeedbackSender sender, FeedbackMessage message, FeedbackProcessor processor) {
    public PendingFeedback {
        Domain.finite("feedback", "timestamp", message.timestamp(), "s");
    }

    /** The order of use; a stable sort leaves equal ones as they arrived. */
    static final Comparator<PendingFeedback> ORDER =
            Comparator.<PendingFeedback>comparingLong(p -> p.message().worldObjectId())
                    .thenComparingDouble(p -> p.message().timestamp());

    long objectId() {
        return message.worldObjectId();
    }

    boolean isBeforeStep() {
        return processor.phase() == Phase.BEFORE_STEP;
    }
}
