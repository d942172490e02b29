package org.auvsim.auvsml.document;

import org.auvsim.core.description.Default;
import org.auvsim.core.description.Name;
import org.auvsim.core.description.Unit;

import java.util.List;
import java.util.OptionalDouble;

/**
 * Which of the server's feedback time-steppers a scenario asks for, and with what (thesis, section
 * 7.2); here they are data alone.
 */
public interface FeedbackTimestepping {
    /** Feedback is ignored. */
    record NoFeedbackTimestepper() implements FeedbackTimestepping {}

    /**
     * Each step is announced by its projected state, then feedback is awaited for a fixed time.
     *
     * @param waiting real time to wait for feedback
     * @param client if any are named, the wait ends early once all of them have answered
     */
    record SimpleFixedTimeFeedbackTimestepper(
            @Name("wait") @Unit("s") double waiting, List<AwaitedClient> client)
            implements FeedbackTimestepping {
        /**
         * A checked choice.
         *
         * @throws IllegalArgumentException if the wait is not above 0
         */
        public SimpleFixedTimeFeedbackTimestepper {
            if (!(waiting > 0)) {
                throw new IllegalArgumentException(
                        "the wait for feedback must be above 0 s, but is " + waiting + " s");
            }
        }
    }

    /** Feedback is never awaited; what has arrived is applied between two steps. */
    record AsynchronousFeedbackTimestepper() implements FeedbackTimestepping {}

    /**
     * Each step is announced by its projected state, and made when each member has answered it.
     *
     * @param timeout real time to wait for the answers; by default for ever
     * @param then what is done when it is over
     */
    record LockstepTimestepper(@Unit("s") OptionalDouble timeout, @Default("wait") WhenLate then)
            implements FeedbackTimestepping {
        /**
         * A checked choice.
         *
         * @throws IllegalArgumentException if the time is not above 0
         */
        public LockstepTimestepper {
            if (timeout.isPresent() && !(timeout.getAsDouble() > 0)) {
                throw new IllegalArgumentException(
                        "the timeout of lock-step must be above 0 s, but is "
                                + timeout.getAsDouble()
                                + " s");
            }
        }
    }

    /** A client that a step waits for. */
    record AwaitedClient(String name) {}
}
