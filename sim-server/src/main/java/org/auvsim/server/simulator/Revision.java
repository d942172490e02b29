package org.auvsim.server.simulator;

import org.auvsim.auvsml.ErrorCode;
import org.auvsim.auvsml.message.command.RefusedException;
import org.auvsim.core.world.World;
import org.auvsim.server.feedback.AppliedFeedback;
import org.auvsim.server.feedback.CorrectiveFeedbackSystem;
import org.auvsim.server.feedback.PastStep;
import org.auvsim.server.feedback.PendingFeedback;
import org.auvsim.server.simulator.History.Moment;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/** Late feedback, and the steps of the past as they are made again with it. */
final class Revision {
    private static final Logger LOG = LoggerFactory.getLogger(Revision.class);

    private final Simulation simulation;
    private final World world;
    private final CorrectiveFeedbackSystem feedback;
    private final Requests requests;
    private final List<Moment> moments;
    private final List<PendingFeedback> late;
    private final List<Moment> again = new ArrayList<>();
    private final Map<PendingFeedback, AppliedFeedback> corrections = new LinkedHashMap<>();
    private final List<Runnable> refused = new ArrayList<>();

    /** A revision of the steps in {@code moments}, the last of which ended now. */
    Revision(
            Simulation simulation,
            CorrectiveFeedbackSystem feedback,
            Requests requests,
            List<Moment> moments,
            List<PendingFeedback> late) {
        this.simulation = simulation;
        this.world = simulation.world();
        this.feedback = feedback;
        this.requests = requests;
        this.moments = moments;
        this.late = late;
    }

    /** The beginning (s) of the first step that is made again. */
    double from() {
        return moments.getFirst().step().start();
    }

    /** The steps that were made again. */
    List<Moment> again() {
        return again;
    }

    /** What the late feedback has corrected. */
    Map<PendingFeedback, AppliedFeedback> corrections() {
        return corrections;
    }

    /** Tells clients what they did and what is refused now. */
    void tellRefused() {
        refused.forEach(Runnable::run);
    }

    /**
     * Goes back, and makes all the steps.
     *
     * @throws RuntimeException if one cannot be made; the simulation is then somewhere in the past
     */
    void make() {
        simulation.restoreWorld(moments.getFirst().before());
        moments.forEach(this::make);
    }

    private void make(Moment moment) {
        List<PendingFeedback> added =
                late.stream().filter(l -> moment.step().contains(l.message().timestamp())).toList();
        List<PendingFeedback> all = new ArrayList<>(moment.feedback());
        all.addAll(added);
        SimulationState before = simulation.state();
        SilentAudience heard = make(before, moment.step(), all);
        for (PendingFeedback one : added) {
            Optional.ofNullable(heard.applied().get(one))
                    .ifPresent(applied -> corrections.put(one, applied));
        }
        heard.refused().forEach((one, why) -> refused.add(() -> one.sender().refused(why)));
        all.removeAll(heard.refused().keySet());
        List<Deed> after = new ArrayList<>(moment.after());
        after.removeIf(this::isRefused);
        again.add(new Moment(before, moment.step(), List.copyOf(all), after));
    }

    /** Makes a step again, up to where it ended, be it cut short by a collision or not. */
    private SilentAudience make(SimulationState before, PastStep step, List<PendingFeedback> all) {
        SilentAudience audience = new SilentAudience();
        feedback.remake(step.wanted(), all, audience);
        if (step.isPassed(world.time())) { // the collision that ended it does not happen now
            simulation.restoreWorld(before);
            audience = new SilentAudience();
            feedback.remake(step.end() - step.start(), all, audience);
        }
        while (!step.isOver(world.time())) {
            feedback.remake(step.end() - world.time(), List.of(), audience);
        }
        return audience;
    }

    private boolean isRefused(Deed deed) {
        Optional<Runnable> telling = requests.repeat(deed);
        telling.ifPresent(refused::add);
        return telling.isPresent();
    }

    /** Tells who sent the feedback that it cannot be used. */
    void refuse(RuntimeException why) {
        String reason = Optional.ofNullable(why.getMessage()).orElse(why.getClass().getName());
        LOG.warn("late feedback cannot be used: {}", reason);
        LOG.debug("a step could not be made again", why);
        RefusedException refusal =
                new RefusedException(
                        ErrorCode.REFUSED,
                        "the past cannot be corrected with this feedback, and stays as it was: "
                                + reason);
        late.forEach(l -> l.sender().refused(refusal));
    }
}
