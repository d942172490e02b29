package org.auvsim.server.feedback;

import org.auvsim.auvsml.document.WhenLate;
import org.auvsim.auvsml.message.command.RefusedException;
import org.auvsim.auvsml.message.feedback.DifferentPositionFeedbackMessage;
import org.auvsim.auvsml.message.feedback.FeedbackMessage;
import org.auvsim.core.math.Vec3;
import org.auvsim.core.world.World;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.BooleanSupplier;
import java.util.function.Consumer;

/** Writes down what a step tells its clients, and answers as the one robot that is there. */
final class StepRecord implements FeedbackAudience, FeedbackSender {
    /** What was told, in order, as "projected 0.05". */
    final List<String> told = new ArrayList<>();

    final List<AppliedFeedback> applied = new ArrayList<>();
    final List<RefusedException> refused = new ArrayList<>();

    private final World world;
    private final CorrectiveFeedbackSystem system;
    private Consumer<ProjectedWorld> robot = _ -> {};

    StepRecord(World world, FeedbackTimestepper timestepper, FeedbackProcessor... own) {
        this.world = world;
        FeedbackProcessors processors = FeedbackProcessors.standard();
        for (FeedbackProcessor processor : own) {
            processors.add(processor);
        }
        system = new CorrectiveFeedbackSystem(world, timestepper, processors, this);
    }

    /** Lets a robot answer each projected state, while the step waits. */
    void robot(Consumer<ProjectedWorld> robot) {
        this.robot = robot;
    }

    /** Sends that an object is at a position at a time. */
    void send(long objectId, double time, String handler, Vec3 actual) {
        send(
                new DifferentPositionFeedbackMessage(
                        objectId, time, handler, Vec3.ZERO, actual, Vec3.ZERO));
    }

    void send(FeedbackMessage message) {
        system.take(this, message);
    }

    double errorBefore(int correction) {
        return applied.get(correction).before().position().orElseThrow();
    }

    double errorAfter(int correction) {
        return applied.get(correction).after().position().orElseThrow();
    }

    void advanceTimestep() {
        system.advanceTimestep();
    }

    private ProjectedWorld shown = ProjectedWorld.of(World.builder().build(), 1);

    @Override
    public void projected(ProjectedWorld projection) {
        told.add("projected " + projection.time());
        shown = projection;
    }

    @Override
    public void bringFeedback(Duration wait, BooleanSupplier enough) {
        robot.accept(shown);
    }

    @Override
    public void awaitMembers(Optional<Duration> timeout, WhenLate then) {
        told.add("awaited members");
    }

    @Override
    public void advanced() {
        told.add("advanced " + world.time());
    }

    @Override
    public void moved(long objectId) {
        told.add("moved " + objectId);
    }

    @Override
    public void applied(PendingFeedback feedback, AppliedFeedback correction) {
        told.add("applied " + correction.processor());
        applied.add(correction);
    }

    @Override
    public void refused(PendingFeedback feedback, RefusedException why) {
        feedback.sender().refused(why);
    }

    @Override
    public void finished() {
        told.add("finished " + world.time());
    }

    @Override
    public String name() {
        return "robot";
    }

    @Override
    public void refused(RefusedException why) {
        refused.add(why);
    }
}
