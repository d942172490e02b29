package org.auvsim.server.feedback;

import org.auvsim.server.feedback.FeedbackProcessor.Phase;

/**
 * Never waits: between two steps, what has arrived is used as if it were true now, however long it
 * took. Simple and quick; corrections lag behind by the way to the robot and back.
 */
public record AsynchronousFeedbackTimestepper() implements FeedbackTimestepper {
    @Override
    public void advanceTimestep(CorrectedStep step) {
        step.process(Phase.AFTER_STEP); // of the step that was made last
        step.process(Phase.BEFORE_STEP);
        step.advance();
        step.finish();
    }

    @Override
    public FeedbackTiming timing() {
        return FeedbackTiming.UP_TO_NOW;
    }
}
