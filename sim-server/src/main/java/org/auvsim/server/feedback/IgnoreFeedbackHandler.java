package org.auvsim.server.feedback;

/** Leaves the object as it is; the notification says how far that is from what was measured. */
public record IgnoreFeedbackHandler() implements FeedbackProcessor {
    @Override
    public Phase phase() {
        return Phase.AFTER_STEP;
    }

    @Override
    public void process(Correction correction) {
        // nothing is the correction
    }
}
