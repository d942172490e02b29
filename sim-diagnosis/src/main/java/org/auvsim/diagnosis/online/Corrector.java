package org.auvsim.diagnosis.online;

import org.auvsim.server.feedback.DirectPositionChangeFeedbackHandler;
import org.auvsim.server.feedback.FeedbackProcessor;
import org.auvsim.server.feedback.IgnoreFeedbackHandler;
import org.auvsim.server.feedback.KalmanFilterFeedbackHandler;
import org.auvsim.server.feedback.VectorAdjustmentFeedbackHandler;

/** What corrects the object while the learner learns: one of the server's own, as by default. */
public enum Corrector {
    /** Nothing: the object goes its own way. */
    IGNORE("ignore"),
    /** The object gets what was measured. */
    DIRECT_POSITION_CHANGE("direct-position-change"),
    /** It is pushed there. */
    VECTOR_ADJUSTMENT("vector-adjustment"),
    /** What was measured is weighed against the model. */
    KALMAN_FILTER("kalman-filter");

    private final String text;

    Corrector(String text) {
        this.text = text;
    }

    FeedbackProcessor processor() {
        return switch (this) {
            case IGNORE -> new IgnoreFeedbackHandler();
            case DIRECT_POSITION_CHANGE -> new DirectPositionChangeFeedbackHandler();
            case VECTOR_ADJUSTMENT -> new VectorAdjustmentFeedbackHandler();
            case KALMAN_FILTER -> new KalmanFilterFeedbackHandler();
        };
    }

    /** As AUVSML has it. */
    @Override
    public String toString() {
        return text;
    }
}
