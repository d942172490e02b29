package org.auvsim.server.feedback;

/**
 * When a step of the past was made.
 *
 * @param start the world's time before it (s)
 * @param wanted how long it was to be (s)
 * @param end the world's time after it (s)
 */
public record PastStep(double start, double wanted, double end) {
    /** Whether it is made up to its end when the world's time is {@code time} (s). */
    public boolean isOver(double time) {
        return time >= end - CorrectiveFeedbackSystem.SAME_TIME;
    }

    /** Whether a world at {@code time} (s) has gone on beyond its end. */
    public boolean isPassed(double time) {
        return time > end + CorrectiveFeedbackSystem.SAME_TIME;
    }

    /** Whether a time (s) lies in it; its end does, its start does not. */
    public boolean contains(double time) {
        return time > start + CorrectiveFeedbackSystem.SAME_TIME
                && time <= end + CorrectiveFeedbackSystem.SAME_TIME;
    }
}
