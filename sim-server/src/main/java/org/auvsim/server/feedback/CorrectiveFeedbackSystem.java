package org.auvsim.server.feedback;

import org.auvsim.auvsml.ErrorCode;
import org.auvsim.auvsml.message.command.RefusedException;
import org.auvsim.auvsml.message.feedback.FeedbackMessage;
import org.auvsim.core.world.World;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/**
 * Makes the steps of a world and brings the feedback of clients into them (thesis, section 7.2).
 * Belongs to the thread that owns the world.
 */
public final class CorrectiveFeedbackSystem {
    /** So far apart (s) two times may be that mean the same: clients may round them. */
    static final double SAME_TIME = 1e-6;

    private final World world;
    private final FeedbackTimestepper timestepper;
    private final FeedbackProcessors processors;
    private final FeedbackAudience audience;
    private final List<PendingFeedback> pending = new ArrayList<>();
    private final ProcessorMemory memory = new ProcessorMemory();
    private Optional<CorrectedStep> step = Optional.empty();

    /** For a world that makes its steps in this way. */
    public CorrectiveFeedbackSystem(
            World world,
            FeedbackTimestepper timestepper,
            FeedbackProcessors processors,
            FeedbackAudience audience) {
        this.world = world;
        this.timestepper = timestepper;
        this.processors = processors;
        this.audience = audience;
    }

    /**
     * Makes one step.
     *
     * @throws RuntimeException if the world cannot make it; what clients sent for it is dropped
     */
    public void advanceTimestep() {
        CorrectedStep next = new CorrectedStep(world, audience, pending, memory);
        step = Optional.of(next);
        boolean made = false;
        try {
            timestepper.advanceTimestep(next);
            if (!next.isMade()) {
                throw new IllegalStateException(
                        "%s has not advanced the world; it must call advance() once a step"
                                .formatted(timestepper.getClass().getSimpleName()));
            }
            made = true;
        } finally {
            step = Optional.empty();
            if (!made) {
                pending.clear();
            }
        }
    }

    /**
     * Takes a feedback; several for one object are used in order of their timestamps.
     *
     * @throws RefusedException if it cannot be used, with the reason
     */
    public void take(FeedbackSender sender, FeedbackMessage message) {
        FeedbackProcessor processor = processors.named(message.handlerName());
        requireTime(message.timestamp());
        pending.add(new PendingFeedback(sender, message, processor));
        step.ifPresent(s -> s.answered(sender.name()));
    }

    private void requireTime(double timestamp) {
        switch (timestepper.timing()) {
            case NEVER ->
                    throw new RefusedException(
                            ErrorCode.REFUSED,
                            "this simulator uses no feedback; start it with a feedback"
                                    + " time-stepper");
            case UP_TO_NOW -> refuseAfter(world.time(), timestamp);
            case END_OF_STEP -> {
                Optional<Double> end = step.flatMap(CorrectedStep::projectedEnd);
                if (end.isEmpty()) {
                    refuseAfter(world.time(), timestamp);
                    throw late(timestamp);
                }
                refuseAfter(end.get(), timestamp);
                if (timestamp <= world.time() + SAME_TIME) {
                    throw late(timestamp);
                }
            }
        }
    }

    private static void refuseAfter(double latest, double timestamp) {
        if (timestamp > latest + SAME_TIME) {
            throw new RefusedException(
                    ErrorCode.INVALID_VALUE,
                    "feedback for %s s is too early: the latest state sent is that of %s s"
                            .formatted(timestamp, latest));
        }
    }

    private RefusedException late(double timestamp) {
        return new RefusedException(
                ErrorCode.REFUSED,
                "feedback for %s s is too late: the world is at %s s; answer the projected movement"
                                .formatted(timestamp, world.time())
                        + " with its own timestamp while its step waits");
    }
}
