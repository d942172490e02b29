package org.auvsim.server.feedback;

/** Ignores what robots measure: feedback is refused. */
public record NoFeedbackTimestepper() implements FeedbackTimestepper {
    @Override
    public void advanceTimestep(CorrectedStep step) {
        step.advance();
        step.finish();
    }

    @Override
    public FeedbackTiming timing() {
        return FeedbackTiming.NEVER;
    }
}
