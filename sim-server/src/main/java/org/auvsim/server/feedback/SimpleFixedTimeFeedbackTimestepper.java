package org.auvsim.server.feedback;

import org.auvsim.core.description.Unit;
import org.auvsim.server.feedback.FeedbackProcessor.Phase;

import java.time.Duration;
import java.util.List;

/**
 * Shows the clients where the step will end, gives them some time to say where they are, and makes
 * the step with that (thesis, section 7.2).
 *
 * @param waitTime how long, on the wall's clock
 * @param client the wait ends early when each of these has answered; none: never
 */
public record SimpleFixedTimeFeedbackTimestepper(
        @Unit("s") double waitTime, List<AwaitedClient> client) implements FeedbackTimestepper {
    private static final double LONGEST_WAIT = 3600;

    /**
     * A checked time-stepper.
     *
     * @throws IllegalArgumentException if the wait is not positive, or longer than an hour
     */
    public SimpleFixedTimeFeedbackTimestepper {
        if (!(waitTime > 0 && waitTime <= LONGEST_WAIT)) {
            throw new IllegalArgumentException(
                    "wait-time must be above 0 s and at most %s s, but is %s s"
                            .formatted(LONGEST_WAIT, waitTime));
        }
        client = List.copyOf(client);
    }

    /** Waits for this time whoever answers. */
    public static SimpleFixedTimeFeedbackTimestepper waiting(Duration wait) {
        return new SimpleFixedTimeFeedbackTimestepper(wait.toNanos() * 1e-9, List.of());
    }

    /** Waits for this time, or until each of these clients has answered. */
    public static SimpleFixedTimeFeedbackTimestepper waiting(Duration wait, String... clients) {
        List<AwaitedClient> awaited = List.of(clients).stream().map(AwaitedClient::new).toList();
        return new SimpleFixedTimeFeedbackTimestepper(wait.toNanos() * 1e-9, awaited);
    }

    @Override
    public void advanceTimestep(CorrectedStep step) {
        step.project();
        step.awaitFeedback(
                Duration.ofNanos((long) (waitTime * 1e9)),
                client.stream().map(AwaitedClient::name).toList());
        step.process(Phase.BEFORE_STEP);
        step.advance();
        step.process(Phase.AFTER_STEP);
        step.finish();
    }
}
