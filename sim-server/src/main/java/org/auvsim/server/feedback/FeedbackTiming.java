package org.auvsim.server.feedback;

/** Which feedback a {@link FeedbackTimestepper} can use, by its timestamp. */
public enum FeedbackTiming {
    /** None at all. */
    NEVER,
    /** What was true at the end of the step that is projected, or within it, and no other. */
    END_OF_STEP,
    /** What was true now or earlier; it is used as if it were true now. */
    UP_TO_NOW
}
