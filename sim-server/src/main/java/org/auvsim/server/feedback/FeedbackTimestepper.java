package org.auvsim.server.feedback;

/** Makes one step of the world and decides when feedback comes into it (thesis, section 7.2). */
public interface FeedbackTimestepper {
    /** Puts the parts of a step in order; {@link CorrectedStep#advance()} is one of them. */
    void advanceTimestep(CorrectedStep step);

    /** Which feedback is of use; by default that which answers the projected state. */
    default FeedbackTiming timing() {
        return FeedbackTiming.END_OF_STEP;
    }

    /** Whether clients are members, whose messages are used in an order of their own. */
    default boolean isLockstep() {
        return false;
    }
}
