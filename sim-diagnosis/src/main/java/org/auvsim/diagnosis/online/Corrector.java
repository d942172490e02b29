package org.auvsim.diagnosis.online;

import org.auvsim.server.feedback.DirectPositionChangeFeedbackHandler;
import org.auvsim.server.feedback.FeedbackProcessor;
import org.auvsim.server.feedback.IgnoreFeedbackHandler;
import org.auvsim.server.feedback.KalmanFilterFeedbackHandler;
import org.auvsim.server.feedback.VectorAdjustmentFeedbackHandler;

/** What corrects the object while the learner learns: one of the server's own, as by default. */
public enum Corrector {
    /** Nothing: the object goes its own way. */
    IGNORE("ignore", new IgnoreFeedbackHandler()),
    /** The object gets what was measured. */
    DIRECT_POSITION_CHANGE("direct-position-change", new DirectPositionChangeFeedbackHandler()),
    /** It is pushed there. */
    VECTOR_ADJUSTMENT("vector-adjustment", new VectorAdjustmentFeedbackHandler()),
    /** What was measured is weighed against the model. */
    KALMAN_FILTER("kalman-filter", new KalmanFilterFeedbackHandler());

    private final String text;
    private final FeedbackProcessor processor;

    Corrector(String text, FeedbackProcessor processor) {
        this.text = text;
        this.processor = processor;
    }

    FeedbackProcessor processor() {
        return processor;
    }

    /** As AUVSML has it. */
    @Override
    public String toString() {
        return text;
    }
}
