package org.auvsim.server.feedback;

import org.auvsim.server.feedback.FeedbackProcessor.Phase;

/** Makes a step of the past again, with the feedback that is known for it: it waits for nobody. */
record RemakingTimestepper() implements FeedbackTimestepper {
    @Override
    public void advanceTimestep(CorrectedStep step) {
        step.project();
        step.process(Phase.BEFORE_STEP);
        step.advance();
        step.process(Phase.AFTER_STEP);
        step.finish();
    }
}
