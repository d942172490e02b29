package org.auvsim.server.feedback;

import org.auvsim.auvsml.ErrorCode;
import org.auvsim.auvsml.document.WhenLate;
import org.auvsim.auvsml.message.command.RefusedException;
import org.auvsim.core.entity.MovementState;
import org.auvsim.core.entity.WorldObject;
import org.auvsim.core.entity.Wrench;
import org.auvsim.core.world.World;
import org.auvsim.server.feedback.FeedbackProcessor.Phase;

import java.time.Duration;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;

/**
 * One step of a world, as a {@link FeedbackTimestepper} puts it together out of its parts (thesis,
 * section 7.2). {@link #advance()} and then {@link #finish()} must be called once.
 */
public final class CorrectedStep {
    private final World world;
    private final FeedbackAudience audience;
    private final List<PendingFeedback> pending;
    private final ProcessorMemory memory;
    private final double start;
    private final double wanted;
    private final Set<String> answered = new HashSet<>();
    private final List<StepCorrection> pushed = new ArrayList<>();
    private final Map<Long, StepCourse> courses = new TreeMap<>();
    private StepForces forces = new StepForces();
    private Optional<ProjectedWorld> projection = Optional.empty();
    private Optional<Double> announcedEnd = Optional.empty();
    private Optional<World> beginning = Optional.empty();
    private boolean made;

    /** A step that takes at most {@code most} (s). */
    CorrectedStep(
            World world,
            FeedbackAudience audience,
            List<PendingFeedback> pending,
            ProcessorMemory memory,
            double most) {
        this.world = world;
        this.audience = audience;
        this.pending = pending;
        this.memory = memory;
        this.start = world.time();
        this.wanted = wanted(most);
    }

    /**
     * The world's time step, or less: to the time of a feedback that the last step fell short of.
     */
    private double wanted(double most) {
        double wanted = most;
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

    ProjectedWorld projection() {
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

    /**
     * Waits until each member has answered.
     *
     * @param timeout how long, on the wall's clock; empty: for ever
     * @param then what is done when that is over
     */
    public void awaitMembers(Optional<Duration> timeout, WhenLate then) {
        audience.awaitMembers(timeout, then);
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
            if (feedback.processor().phase() == phase && isDue(feedback)) {
                pending.remove(feedback);
                process(feedback);
            }
        }
    }

    private boolean isDue(PendingFeedback feedback) {
        return feedback.isBeforeStep()
                || feedback.message().timestamp()
                        <= world.time() + CorrectiveFeedbackSystem.SAME_TIME;
    }

    private void process(PendingFeedback feedback) {
        try {
            requirePossible(feedback);
            if (feedback.isBeforeStep()) {
                correctBefore(feedback);
            } else {
                correctAfter(feedback);
            }
        } catch (RefusedException e) {
            audience.refused(feedback, e);
        }
    }

    private void requirePossible(PendingFeedback feedback) {
        long id = feedback.objectId();
        if (world.find(id).isEmpty()) {
            throw new RefusedException(
                    ErrorCode.UNKNOWN_ENTITY,
                    "no world object has the id %d at %s s".formatted(id, world.time()));
        }
        WorldObject object = world.object(id);
        if (object.isFixed()) {
            throw new RefusedException(
                    ErrorCode.REFUSED,
                    "'%s' is fixed, and stays where it is whatever is measured"
                            .formatted(object.name()));
        }
        if (feedback.isBeforeStep() && projection().time() <= world.time()) {
            throw new RefusedException(
                    ErrorCode.REFUSED,
                    "nothing can push '%s' now: this step takes no time, it is a collision"
                            .formatted(object.name()));
        }
    }

    private void correctBefore(PendingFeedback feedback) {
        StepForces others = forces;
        StepCorrection correction = new StepCorrection(this, feedback);
        try {
            feedback.processor().process(correction);
        } catch (RefusedException | IllegalArgumentException e) {
            forces = others;
            throw refused(e);
        }
        pushed.add(correction);
    }

    private void correctAfter(PendingFeedback feedback) {
        StepCorrection correction = new StepCorrection(this, feedback);
        WorldObject object = correction.object();
        MovementState uncorrected = object.movementState();
        try {
            feedback.processor().process(correction);
        } catch (RefusedException | IllegalArgumentException e) {
            object.setMovementState(uncorrected);
            throw refused(e);
        }
        if (!made) {
            projection = Optional.empty(); // the step begins elsewhere now
        } else if (!object.movementState().equals(uncorrected)) {
            audience.moved(object.id());
        }
        audience.applied(feedback, correction.applied(world));
    }

    private static RefusedException refused(RuntimeException e) {
        return e instanceof RefusedException refused
                ? refused
                : new RefusedException(ErrorCode.INVALID_VALUE, String.valueOf(e.getMessage()));
    }

    /** Lets the world make the step, with the forces that corrections added to it. */
    public void advance() {
        Map<Long, RigidMotion> starts = motionsOfCorrected();
        if (pending.stream().anyMatch(p -> p.processor().looksBack())) {
            beginning = Optional.of(world.copy());
        }
        forces.advance(world, pushed.isEmpty() ? wanted : projection().time() - world.time());
        made = true;
        starts.forEach(this::keepCourse);
        audience.advanced();
        for (StepCorrection correction : pushed) {
            if (world.find(correction.feedback().objectId()).isPresent()) {
                audience.applied(correction.feedback(), correction.applied(world));
            }
        }
    }

    private Map<Long, RigidMotion> motionsOfCorrected() {
        Map<Long, RigidMotion> motions = new TreeMap<>();
        for (PendingFeedback feedback : pending) {
            if (world.find(feedback.objectId()).isPresent()) {
                motions.put(feedback.objectId(), RigidMotion.of(world.object(feedback.objectId())));
            }
        }
        return motions;
    }

    private void keepCourse(long id, RigidMotion from) {
        if (world.find(id).isPresent()) {
            RigidMotion end = RigidMotion.of(world.object(id));
            courses.put(id, new StepCourse(start, from, world.time(), end));
        }
    }

    /** Tells that the step is over. */
    public void finish() {
        audience.finished();
    }

    boolean isMade() {
        return made;
    }

    World world() {
        return world;
    }

    ProcessorMemory memory() {
        return memory;
    }

    StepForces forces() {
        return forces;
    }

    void push(long objectId, Wrench firstHalf, Wrench secondHalf) {
        forces = forces.with(objectId, firstHalf, secondHalf);
    }

    /** How long the step is (s). */
    double duration() {
        return (made ? world.time() : projection().time()) - start;
    }

    /** Where the step would leave an object, before it is made. */
    RigidMotion projected(long objectId) {
        return projection()
                .motion(objectId)
                .orElseGet(() -> RigidMotion.of(world.object(objectId)));
    }

    /** How an object moved when the step began. */
    RigidMotion start(long objectId) {
        return RigidMotion.of(beginning().object(objectId));
    }

    /** The world before the step. */
    World beginning() {
        if (!made) {
            return world;
        }
        return beginning.orElseThrow(
                () ->
                        new IllegalStateException(
                                "only a processor that looksBack() may ask for the world before"
                                        + " the step"));
    }

    /**
     * Where the end of the step ought to leave the object. Clients that were shown no end of the
     * step measured before it, and the model adds the rest.
     */
    Target target(PendingFeedback feedback) {
        StepCourse course = course(feedback);
        double measuredAt = feedback.message().timestamp();
        double at = announcedEnd.isEmpty() ? world.time() : measuredAt;
        RigidMotion model = course.at(at);
        return Target.of(feedback.message().measurement(), model).carried(model, course.end());
    }

    private StepCourse course(PendingFeedback feedback) {
        long id = feedback.objectId();
        RigidMotion now = RigidMotion.of(world.object(id));
        return feedback.isBeforeStep()
                ? new StepCourse(start, now, projection().time(), projected(id))
                : courses.getOrDefault(id, StepCourse.at(world.time(), now));
    }
}
