package org.auvsim.server.feedback;

import org.auvsim.auvsml.message.feedback.FeedbackMessage;
import org.auvsim.core.entity.WorldObject;
import org.auvsim.core.entity.Wrench;
import org.auvsim.core.step.StepException;
import org.auvsim.core.world.World;
import org.auvsim.core.world.WorldException;

import java.util.Optional;

/** What one feedback's processor sees of a step, and does to it. */
final class StepCorrection implements Correction {
    private final CorrectedStep step;
    private final PendingFeedback feedback;
    private final Target target;
    private final MeasurementErrors errorsBefore;
    private boolean reached = true;

    StepCorrection(CorrectedStep step, PendingFeedback feedback) {
        this.step = step;
        this.feedback = feedback;
        this.target = step.target(feedback);
        this.errorsBefore =
                target.errors(feedback.isBeforeStep() ? projected() : RigidMotion.of(object()));
        errorsBefore.requirePossible(object().name());
    }

    PendingFeedback feedback() {
        return feedback;
    }

    /** What the correction has come to. */
    AppliedFeedback applied(World world) {
        return new AppliedFeedback(
                id(),
                world.time(),
                feedback.processor().name(),
                errorsBefore,
                target.errors(RigidMotion.of(world.object(id()))),
                target,
                reached,
                world.overlaps(id()));
    }

    private long id() {
        return feedback.objectId();
    }

    @Override
    public FeedbackMessage message() {
        return feedback.message();
    }

    @Override
    public WorldObject object() {
        return step.world().object(id());
    }

    @Override
    public double time() {
        return feedback.isBeforeStep() ? step.projection().time() : step.world().time();
    }

    @Override
    public Target target() {
        return target;
    }

    @Override
    public RigidMotion projected() {
        return step.isMade() ? RigidMotion.of(object()) : step.projected(id());
    }

    @Override
    public double duration() {
        return step.duration();
    }

    @Override
    public Optional<RigidMotion> tried(Wrench firstHalf, Wrench secondHalf) {
        World copy = step.world().copy();
        try {
            step.forces().with(id(), firstHalf, secondHalf).advance(copy, duration());
            return motionIn(copy);
        } catch (StepException | WorldException | IllegalArgumentException e) {
            return Optional.empty();
        }
    }

    private Optional<RigidMotion> motionIn(World copy) {
        return copy.find(id()).map(_ -> RigidMotion.of(copy.object(id())));
    }

    @Override
    public void push(Wrench firstHalf, Wrench secondHalf) {
        step.push(id(), firstHalf, secondHalf);
    }

    @Override
    public RigidMotion start() {
        return step.start(id());
    }

    @Override
    public Optional<RigidMotion> steppedFrom(RigidMotion start) {
        World copy = step.beginning().copy();
        try {
            start.giveTo(copy.object(id()));
            boolean ended = step.forces().complete(copy, duration());
            return ended ? motionIn(copy) : Optional.empty();
        } catch (StepException | WorldException | IllegalArgumentException e) {
            return Optional.empty();
        }
    }

    @Override
    public <M> Optional<M> memory(Class<M> type) {
        return step.memory().recall(id(), feedback.processor().name(), type);
    }

    @Override
    public void remember(Object value) {
        step.memory().remember(id(), feedback.processor().name(), value);
    }

    @Override
    public void fellShort() {
        reached = false;
    }
}
