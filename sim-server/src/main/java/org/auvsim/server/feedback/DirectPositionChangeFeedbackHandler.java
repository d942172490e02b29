package org.auvsim.server.feedback;

import org.auvsim.auvsml.ErrorCode;
import org.auvsim.auvsml.message.command.RefusedException;
import org.auvsim.auvsml.message.feedback.DifferentPositionFeedbackMessage;

/**
 * Direct alteration: puts the object where the robot is (thesis, section 7.2). Momenta and
 * orientation stay, and no collision is looked for: the object may end inside another, which the
 * notification then names.
 */
public record DirectPositionChangeFeedbackHandler() implements FeedbackProcessor {
    @Override
    public Phase phase() {
        return Phase.AFTER_STEP;
    }

    @Override
    public void process(DifferentPositionFeedbackMessage feedback, Correction correction) {
        if (correction.object().isFixed()) {
            throw new RefusedException(
                    ErrorCode.REFUSED,
                    "'%s' is fixed, and stays where it is whatever is measured"
                            .formatted(correction.object().name()));
        }
        correction.object().setPosition(correction.target());
    }
}
