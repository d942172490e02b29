package org.auvsim.server.feedback;

import org.auvsim.server.feedback.FeedbackProcessor.Phase;

import java.time.Duration;
import java.util.List;

/**
 * Shows the clients where the step will end, gives them some time to say where they are, and makes
 * the step with that (thesis, section 7.2).
 *
 * @param waiting how long, on the wall's clock
 * @param clients the wait ends early when each of these, by name, has answered; none: never
 */
public record SimpleFixedTimeFeedbackTimestepper(Duration waiting, List<String> clients)
        implements FeedbackTimestepper {
    private static final Duration LONGEST = Duration.ofHours(1);

    /**
     * A checked time-stepper.
     *
     * @throws IllegalArgumentException if the wait is negative, or longer than an hour
     */
    public SimpleFixedTimeFeedbackTimestepper {
        if (waiting.isNegative() || waiting.compareTo(LONGEST) > 0) {
            throw new IllegalArgumentException(
                    "the wait for feedback must be 0 s or more and at most %d s, but is %s s"
                            .formatted(LONGEST.toSeconds(), waiting.toNanos() * 1e-9));
        }
        clients = List.copyOf(clients);
    }

    /** Waits for this time, whoever answers. */
    public static SimpleFixedTimeFeedbackTimestepper waiting(Duration wait) {
        return new SimpleFixedTimeFeedbackTimestepper(wait, List.of());
    }

    @Override
    public void advanceTimestep(CorrectedStep step) {
        step.project();
        step.awaitFeedback(waiting, clients);
        step.process(Phase.BEFORE_STEP);
        step.advance();
        step.process(Phase.AFTER_STEP);
        step.finish();
    }
}
