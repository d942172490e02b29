package org.auvsim.server.feedback;

import org.auvsim.auvsml.document.Deviations;

/** A filter that trusts measurements alone does as direct alteration. */
class KalmanFilterFeedbackHandlerTest extends FeedbackProcessorContract {
    @Override
    protected FeedbackProcessor processor() {
        return new KalmanFilterFeedbackHandler(
                0.1, 0.1, new Deviations(1e-9, 1e-9, 1e-9, 1e-9), new Deviations(1, 0.2, 0.5, 0.1));
    }

    @Override
    protected double accuracy() {
        return 1e-12;
    }
}
