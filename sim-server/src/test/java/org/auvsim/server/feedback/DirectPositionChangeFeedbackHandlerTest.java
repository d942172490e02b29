package org.auvsim.server.feedback;

class DirectPositionChangeFeedbackHandlerTest extends FeedbackProcessorContract {
    @Override
    protected FeedbackProcessor processor() {
        return new DirectPositionChangeFeedbackHandler();
    }

    @Override
    protected double accuracy() {
        return 0;
    }
}
