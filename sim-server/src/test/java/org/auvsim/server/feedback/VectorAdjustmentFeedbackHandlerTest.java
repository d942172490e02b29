package org.auvsim.server.feedback;

class VectorAdjustmentFeedbackHandlerTest extends FeedbackProcessorContract {
    @Override
    protected FeedbackProcessor processor() {
        return new VectorAdjustmentFeedbackHandler();
    }

    @Override
    protected double accuracy() {
        return 1e-9;
    }
}
