package org.auvsim.server.feedback;

import org.auvsim.auvsml.ErrorCode;
import org.auvsim.auvsml.message.command.RefusedException;
import org.auvsim.core.entity.MovementState;
import org.auvsim.core.entity.WorldObject;
import org.auvsim.core.math.Vec3;
import org.auvsim.core.step.StepException;
import org.auvsim.core.world.World;
import org.auvsim.core.world.WorldException;
import org.auvsim.server.feedback.FeedbackProcessor.Phase;

import java.time.Duration;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;

/**
 * One step of a world, as a {@link FeedbackTimestepper} puts it together out of its parts (thesis,
 * section 7.2). {@link #advance()} and then {@link #finish()} must be called once.
 */
public final class CorrectedStep {
    private final World world;
    private final FeedbackAudience audience;
    private final List<PendingFeedback> pending;
    private final double start;
    private final double wanted;
    private final Set<String> answered = new HashSet<>();
    private final List<Pushed> pushed = new ArrayList<>();
    private StepForces forces = new StepForces();
    private Optional<ProjectedWorld> projection = Optional.empty();
    private Optional<Double> announcedEnd = Optional.empty();
    private boolean made;

    /** A correction whose effect is seen when the step is made. */
    private record Pushed(PendingFeedback feedback, Vec3 target, double errorBefore) {}

    CorrectedStep(World world, FeedbackAudience audience, List<PendingFeedback> pending) {
        this.world = world;
        this.audience = audience;
        this.pending = pending;
        this.start = world.time();
        this.wanted = wanted();
    }

    /**
     * The world's time step, or less: to the time of a feedback that the last step fell short of.
     */
    private double wanted() {
        double wanted = world.timeStep();
        for (PendingFeedback feedback : pending) {
            double ahead = feedback.message().timestamp() - world.time();
            if (ahead > CorrectiveFeedbackSystem.SAME_TIME) {
                wanted = Math.min(wanted, ahead);
            }
        }
        return wanted;
    }

    /** Makes the step on a copy of the world and shows the clients where it ends. */
    public void project() {
        announcedEnd = Optional.of(projection().time());
        audience.projected(projection());
    }

    private ProjectedWorld projection() {
        if (projection.isEmpty()) {
            projection = Optional.of(ProjectedWorld.of(world, wanted));
        }
        return projection.get();
    }

    /** The end of the step (s) as the clients were shown it, while they can still correct it. */
    Optional<Double> projectedEnd() {
        return made ? Optional.empty() : announcedEnd;
    }

    /**
     * Takes feedback, and nothing else.
     *
     * @param wait how long, on the wall's clock
     * @param clients the wait ends early when each of these, by name, has answered; none: never
     */
    public void awaitFeedback(Duration wait, List<String> clients) {
        audience.bringFeedback(wait, () -> !clients.isEmpty() && answered.containsAll(clients));
    }

    void answered(String client) {
        answered.add(client);
    }

    /**
     * Lets the processors of a phase use the feedback that is there: object by object, in order of
     * their timestamps, then as it arrived. What is true only later than the world's time, since a
     * collision ended the step early, waits for a later step.
     */
    public void process(Phase phase) {
        for (PendingFeedback feedback : pending.stream().sorted(PendingFeedback.ORDER).toList()) {
            boolean isDue =
                    phase == Phase.BEFORE_STEP
                            || feedback.message().timestamp()
                                    <= world.time() + CorrectiveFeedbackSystem.SAME_TIME;
            if (feedback.processor().phase() == phase && isDue) {
                pending.remove(feedback);
                process(feedback);
            }
        }
    }

    private void process(PendingFeedback feedback) {
        try {
            requirePossible(feedback);
            if (feedback.processor().phase() == Phase.BEFORE_STEP) {
                correctBefore(feedback);
            } else {
                correctAfter(feedback);
            }
        } catch (RefusedException e) {
            feedback.sender().refused(e);
        }
    }

    private void requirePossible(PendingFeedback feedback) {
        long id = feedback.message().worldObjectId();
        if (world.find(id).isEmpty()) {
            throw new RefusedException(
                    ErrorCode.UNKNOWN_ENTITY, "world object %d has left the world".formatted(id));
        }
        boolean isBeforeStep = feedback.processor().phase() == Phase.BEFORE_STEP;
        if (isBeforeStep && projection().time() <= world.time()) {
            throw new RefusedException(
                    ErrorCode.REFUSED,
                    "nothing can push '%s' now: this step takes no time, it is a collision"
                            .formatted(world.object(id).name()));
        }
    }

    private void correctBefore(PendingFeedback feedback) {
        StepCorrection correction = new StepCorrection(feedback);
        double before = correction.projected().position().distance(correction.target());
        feedback.processor().process(feedback.message(), correction);
        pushed.add(new Pushed(feedback, correction.target(), before));
    }

    private void correctAfter(PendingFeedback feedback) {
        StepCorrection correction = new StepCorrection(feedback);
        double before = correction.object().position().distance(correction.target());
        feedback.processor().process(feedback.message(), correction);
        if (made) {
            audience.moved(correction.object().id());
        } else {
            projection = Optional.empty(); // the step begins elsewhere now
        }
        announce(feedback, correction.target(), before);
    }

    private void announce(PendingFeedback feedback, Vec3 target, double before) {
        long id = feedback.message().worldObjectId();
        audience.applied(
                new AppliedFeedback(
                        id,
                        world.time(),
                        feedback.processor().name(),
                        before,
                        world.object(id).position().distance(target),
                        world.overlaps(id)));
    }

    /** Lets the world make the step, with the forces that corrections added to it. */
    public void advance() {
        forces.advance(world, pushed.isEmpty() ? wanted : projection().time() - world.time());
        made = true;
        audience.advanced();
        for (Pushed push : pushed) {
            if (world.find(push.feedback().message().worldObjectId()).isPresent()) {
                announce(push.feedback(), push.target(), push.errorBefore());
            }
        }
    }

    /** Tells that the step is over. */
    public void finish() {
        audience.finished();
    }

    boolean isMade() {
        return made;
    }

    private final class StepCorrection implements Correction {
        private final PendingFeedback feedback;
        private final long id;

        StepCorrection(PendingFeedback feedback) {
            this.feedback = feedback;
            this.id = feedback.message().worldObjectId();
        }

        @Override
        public WorldObject object() {
            return world.object(id);
        }

        /**
         * Where clients were shown no end of the step, they measured before it: the model adds it.
         */
        @Override
        public Vec3 target() {
            Vec3 measured = feedback.message().actualPosition();
            boolean isBeforeStep = feedback.processor().phase() == Phase.BEFORE_STEP;
            return isBeforeStep && announcedEnd.isEmpty()
                    ? measured.plus(projected().position()).minus(object().position())
                    : measured;
        }

        @Override
        public MovementState projected() {
            if (made && projection.isEmpty()) {
                return object().movementState();
            }
            return Optional.ofNullable(projection().states().get(id))
                    .orElseGet(() -> object().movementState());
        }

        @Override
        public double duration() {
            return (made ? world.time() : projection().time()) - start;
        }

        @Override
        public Optional<MovementState> tried(Vec3 firstHalf, Vec3 secondHalf) {
            World copy = world.copy();
            try {
                forces.with(id, firstHalf, secondHalf).advance(copy, duration());
                return copy.find(id).isPresent()
                        ? Optional.of(copy.object(id).movementState())
                        : Optional.empty();
            } catch (StepException | WorldException | IllegalArgumentException e) {
                return Optional.empty();
            }
        }

        @Override
        public void push(Vec3 firstHalf, Vec3 secondHalf) {
            forces = forces.with(id, firstHalf, secondHalf);
        }
    }
}
