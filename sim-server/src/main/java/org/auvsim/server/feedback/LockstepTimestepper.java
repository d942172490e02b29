package org.auvsim.server.feedback;

import org.auvsim.auvsml.document.WhenLate;
import org.auvsim.server.feedback.FeedbackProcessor.Phase;

import java.time.Duration;
import java.util.Optional;

/**
 * Goes on only when every member has answered: simulator and clients keep step, whatever the delays
 * on the way. What members send is used in an order that does not depend on its arrival, so that a
 * distributed simulation goes on as a local one would, bit for bit.
 *
 * @param timeout how long, on the wall's clock, a step waits; empty: for ever
 * @param then what is done when that is over
 */
public record LockstepTimestepper(Optional<Duration> timeout, WhenLate then)
        implements FeedbackTimestepper {
    /**
     * A checked time-stepper.
     *
     * @throws IllegalArgumentException if the time is not above 0
     */
    public LockstepTimestepper {
        if (timeout.isPresent() && !timeout.get().isPositive()) {
            throw new IllegalArgumentException(
                    "the timeout of lock-step must be above 0 s, but is %s s"
                            .formatted(timeout.get().toNanos() * 1e-9));
        }
    }

    /** Waits for ever. */
    public LockstepTimestepper() {
        this(Optional.empty(), WhenLate.WAIT);
    }

    @Override
    public void advanceTimestep(CorrectedStep step) {
        step.project();
        step.awaitMembers(timeout, then);
        step.process(Phase.BEFORE_STEP);
        step.advance();
        step.process(Phase.AFTER_STEP);
        step.finish();
    }

    @Override
    public boolean isLockstep() {
        return true;
    }
}
