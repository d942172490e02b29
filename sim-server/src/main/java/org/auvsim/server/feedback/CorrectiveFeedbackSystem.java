package org.auvsim.server.feedback;

import org.auvsim.auvsml.ErrorCode;
import org.auvsim.auvsml.message.command.RefusedException;
import org.auvsim.auvsml.message.feedback.FeedbackMessage;
import org.auvsim.core.world.World;

import java.util.ArrayList;
import java.util.Comparator;
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
    private final FeedbackProcessors processors;
    private final FeedbackAudience audience;
    private final List<PendingFeedback> pending = new ArrayList<>();
    private final ProcessorMemory memory = new ProcessorMemory();

    /** What is true of steps that are made: it waits for the past to be corrected. */
    private final List<PendingFeedback> late = new ArrayList<>();

    /** What was taken for the step that is under way or was made last. */
    private final List<PendingFeedback> taken = new ArrayList<>();

    private FeedbackTimestepper timestepper;
    private double reachesBackTo = Double.POSITIVE_INFINITY;
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

    /** How steps are made and when feedback comes into them. */
    public FeedbackTimestepper timestepper() {
        return timestepper;
    }

    /** Makes steps in another way from the next one on. */
    public void setTimestepper(FeedbackTimestepper timestepper) {
        this.timestepper = timestepper;
    }

    /** The processors, by name. */
    public FeedbackProcessors processors() {
        return processors;
    }

    /** Late feedback is taken if it is true of a time (s) after this one. */
    public void reachBackTo(double time) {
        reachesBackTo = time;
    }

    /**
     * Makes one step.
     *
     * @throws RuntimeException if the world cannot make it; what clients sent for it is dropped
     */
    public void advanceTimestep() {
        taken.clear();
        advance(timestepper, audience, world.timeStep(), List.of());
    }

    private void advance(
            FeedbackTimestepper how,
            FeedbackAudience whom,
            double most,
            List<PendingFeedback> known) {
        CorrectedStep next = new CorrectedStep(world, whom, pending, memory, most);
        pending.addAll(known);
        step = Optional.of(next);
        boolean made = false;
        try {
            how.advanceTimestep(next);
            if (!next.isMade()) {
                throw new IllegalStateException(
                        "%s has not advanced the world; it must call advance() once a step"
                                .formatted(how.getClass().getSimpleName()));
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
     * Makes a step of the past again, waiting for nobody.
     *
     * @param most it takes at most so long (s)
     * @param feedback all that is known of it now
     * @param whom to tell
     */
    public void remake(double most, List<PendingFeedback> feedback, FeedbackAudience whom) {
        advance(new RemakingTimestepper(), whom, most, feedback);
    }

    /**
     * Takes a feedback; several for one object are used in order of their timestamps.
     *
     * @throws RefusedException if it cannot be used, with the reason
     */
    public void take(FeedbackSender sender, FeedbackMessage message) {
        FeedbackProcessor processor = processors.named(message.handlerName());
        boolean isLate = isLate(message.timestamp());
        PendingFeedback accepted = new PendingFeedback(sender, message, processor);
        if (isLate) {
            late.add(accepted);
        } else {
            pending.add(accepted);
            taken.add(accepted);
        }
        step.ifPresent(s -> s.answered(sender.name()));
    }

    /** The late feedback that was taken, in order of its times; it is the caller's now. */
    public List<PendingFeedback> takeLate() {
        List<PendingFeedback> taken = new ArrayList<>(late);
        late.clear();
        taken.sort(Comparator.comparingDouble(f -> f.message().timestamp()));
        return taken;
    }

    /** The feedback that was taken while the last step waited for it, and could be used. */
    public List<PendingFeedback> takenInStep() {
        return List.copyOf(taken);
    }

    /** Whether feedback for a time (s) answers the end of a step that clients were just shown. */
    public boolean isForThisStep(double timestamp) {
        return projectedEnd().stream().anyMatch(end -> Math.abs(end - timestamp) <= SAME_TIME);
    }

    /** The end of the step (s) as clients were shown it, while they can still correct it. */
    private Optional<Double> projectedEnd() {
        return step.flatMap(CorrectedStep::projectedEnd);
    }

    /** The feedback that waits for its step, and can be given back later. */
    public List<PendingFeedback> pending() {
        return List.copyOf(pending);
    }

    /** What processors remember, now. */
    public ProcessorMemory memory() {
        return memory.copy();
    }

    /** Lets this feedback wait, and no other, and processors remember this. */
    public void restore(List<PendingFeedback> waiting, ProcessorMemory remembered) {
        pending.clear();
        pending.addAll(waiting);
        memory.restore(remembered);
    }

    /**
     * Whether a feedback is true of a step that is made already.
     *
     * @throws RefusedException if it comes too early, or too late for the past to be corrected
     */
    private boolean isLate(double timestamp) {
        return switch (timestepper.timing()) {
            case NEVER ->
                    throw new RefusedException(
                            ErrorCode.REFUSED,
                            "this simulator uses no feedback; start it with a feedback"
                                    + " time-stepper");
            case UP_TO_NOW -> {
                refuseAfter(world.time(), timestamp);
                yield Double.isFinite(reachesBackTo) && requireWithinReach(timestamp);
            }
            case END_OF_STEP -> {
                refuseAfter(projectedEnd().orElse(world.time()), timestamp);
                boolean isOfThisStep =
                        projectedEnd().isPresent() && timestamp > world.time() + SAME_TIME;
                yield !isOfThisStep && requireWithinReach(timestamp);
            }
        };
    }

    private boolean requireWithinReach(double timestamp) {
        if (timestamp > reachesBackTo + SAME_TIME) {
            return true;
        }
        throw late(timestamp);
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
        String advice =
                Double.isFinite(reachesBackTo)
                        ? "its past can be corrected back to %s s (feedback-horizon)"
                                .formatted(reachesBackTo)
                        : "answer the projected movement with its own timestamp while its step"
                                + " waits, or let the scenario state a feedback-horizon";
        return new RefusedException(
                ErrorCode.REFUSED,
                "feedback for %s s is too late: the world is at %s s; %s"
                        .formatted(timestamp, world.time(), advice));
    }
}
