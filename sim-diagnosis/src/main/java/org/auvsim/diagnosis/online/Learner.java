package org.auvsim.diagnosis.online;

import org.auvsim.auvsml.message.command.AnnounceModelCorrectionCommand;
import org.auvsim.auvsml.message.feedback.FeedbackMessage;
import org.auvsim.auvsml.message.learning.ModelCorrection;
import org.auvsim.auvsml.message.session.ErrorResponse;
import org.auvsim.diagnosis.Investigation;
import org.auvsim.diagnosis.cause.Library;
import org.auvsim.diagnosis.model.BelievedModel;
import org.auvsim.diagnosis.result.Diagnosis;
import org.auvsim.diagnosis.result.Finding;
import org.auvsim.diagnosis.run.MeasuredRun;
import org.auvsim.diagnosis.run.Split;
import org.auvsim.server.feedback.AppliedFeedback;
import org.auvsim.server.simulator.Companion;
import org.auvsim.server.simulator.Messenger;
import org.auvsim.server.simulator.StepMade;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.ArrayBlockingQueue;
import java.util.concurrent.BlockingQueue;
import java.util.function.Function;

/**
 * Learns what the model of one object lacks, on a thread of its own. The simulation thread only
 * puts what it sees into a queue, and never waits.
 */
final class Learner implements Companion {
    private static final Logger LOG = LoggerFactory.getLogger(Learner.class);

    /** So much may happen during a diagnosis; what is more is not learned from. */
    static final int MOST_WAITING = 100_000;

    private static final String WAITING =
            "too little was measured yet to be split; more is waited for";

    private final long objectId;
    private final LearningPlan plan;
    private final Messenger toSimulator;
    private final Function<Investigation, Diagnosis> diagnoses;
    private final BlockingQueue<Observation> heard = new ArrayBlockingQueue<>(MOST_WAITING);
    private final Watcher watcher;
    private final Logbook logbook;
    private final Thread thread;
    private volatile boolean closed;

    /** Belongs to the simulation thread. */
    private boolean hasMissed;

    /** Belongs to the learner's thread, as what follows does. */
    private final Extension extension;

    private List<String> announced = List.of();
    private String stage = "";

    /** Begins to learn. */
    Learner(long objectId, Belief belief, LearningPlan plan, Messenger toSimulator) {
        this(objectId, belief, plan, toSimulator, Investigation::diagnose);
    }

    /** The same, diagnosing otherwise. */
    Learner(
            long objectId,
            Belief belief,
            LearningPlan plan,
            Messenger toSimulator,
            Function<Investigation, Diagnosis> diagnoses) {
        this.objectId = objectId;
        this.extension = new Extension(belief, toSimulator);
        this.plan = plan;
        this.toSimulator = toSimulator;
        this.diagnoses = diagnoses;
        this.watcher = new Watcher(objectId, this::hear);
        this.logbook = new Logbook(plan.keep());
        String body = belief.first().body();
        this.thread =
                Thread.ofPlatform()
                        .daemon()
                        .name("learner of " + body)
                        .uncaughtExceptionHandler(
                                (_, fault) -> LOG.error("no more is learned of '{}'", body, fault))
                        .start(this::run);
    }

    @Override
    public void corrected(FeedbackMessage feedback, AppliedFeedback applied) {
        watcher.corrected(applied);
    }

    @Override
    public void stepMade(StepMade step) {
        watcher.stepMade(step.world());
    }

    private boolean hear(Observation observation) {
        boolean isHeard = heard.offer(observation);
        if (!isHeard && !hasMissed) {
            hasMissed = true;
            LOG.warn(
                    "object {}: more than {} commands and measurements came during a diagnosis:"
                            + " what is more is not learned from, and a new run begins after it",
                    objectId,
                    MOST_WAITING);
        }
        return isHeard;
    }

    @Override
    public void refused(ErrorResponse why) {
        LOG.warn(
                "what was learned of object {} cannot be put into the world: {}",
                objectId,
                why.text());
    }

    @Override
    public void close() {
        closed = true;
        thread.interrupt();
    }

    private void run() {
        Optional<String> tie = extension.belief().first().tie();
        if (tie.isPresent()) {
            LOG.warn("nothing is learned of '{}': {}", body(), tie.get());
            return;
        }
        try {
            while (!closed) {
                logbook.add(heard.take());
                List<Observation> more = new ArrayList<>();
                heard.drainTo(more);
                more.forEach(logbook::add);
                if (logbook.newTime() >= plan.after()) {
                    learn();
                }
            }
        } catch (InterruptedException e) {
            LOG.debug("learning has ended");
        }
    }

    /** From what there is, if that is enough. A fault of it is no hindrance to learn from more. */
    private void learn() throws InterruptedException {
        String body = body();
        try {
            Optional<Split> split = split(logbook.runs());
            if (split.isEmpty()) {
                if (isNew(WAITING)) {
                    LOG.info("'{}': {}", body, WAITING);
                }
                return;
            }
            learn(extension.belief().under(logbook.forces()), split.get());
        } catch (RuntimeException e) {
            LOG.error("nothing is learned of '{}' until more is measured", body, e);
        }
        logbook.read();
    }

    /** Empty: they are too few, or the only one is too short. */
    private static Optional<Split> split(List<MeasuredRun> runs) {
        try {
            return Optional.of(Split.of(runs));
        } catch (IllegalArgumentException e) {
            LOG.debug("what was measured is not split yet: {}", e.getMessage());
            return Optional.empty();
        }
    }

    private void learn(BelievedModel model, Split split) throws InterruptedException {
        Diagnosis found = diagnoses.apply(investigation(model, split));
        if (closed) {
            LOG.info("'{}': the diagnosis was stopped", model.body());
            return;
        }
        LOG.info("'{}': {}", model.body(), found.sentence());
        switch (found.verdict()) {
            case EXPLAINED -> tell(model, found);
            case NONE -> takeBack(found);
            case UNEXPLAINED, UNDECIDED ->
                    LOG.debug("'{}': what was learned before stays", model.body());
        }
    }

    private Investigation investigation(BelievedModel model, Split split) {
        return new Investigation(
                        model,
                        split.fit(),
                        split.heldOut(),
                        Library.of(model, split.fit()),
                        plan.seed(),
                        this::goesOn)
                .by(plan.method());
    }

    /** Tells each new stage of a diagnosis; whether anybody still wants to know. */
    private boolean goesOn(String now, double share) {
        if (isNew(now)) {
            LOG.info("'{}': {} ({} %)", body(), now, Math.round(100 * share));
        }
        return !closed;
    }

    private boolean isNew(String now) {
        boolean isNew = !now.equals(stage);
        stage = now;
        return isNew;
    }

    private String body() {
        return extension.belief().first().body();
    }

    private void tell(BelievedModel diagnosed, Diagnosis found) throws InterruptedException {
        List<String> causes = found.selected().stream().map(Finding::name).toList();
        if (!plan.extendsWorld() && causes.equals(announced)) {
            return;
        }
        announced = causes;
        announce(Announcement.of(found, plan.extendsWorld() && isPutIntoWorld(diagnosed, found)));
    }

    /** What was found of sensors alone changes no world. */
    private boolean isPutIntoWorld(BelievedModel diagnosed, Diagnosis found)
            throws InterruptedException {
        Belief next = extension.belief().learning(diagnosed, found.extended());
        return extension.reaches(next) && next.hasLearned();
    }

    /**
     * What was learned from less, as by all that was measured the first model lacks nothing. If
     * that is refused, the next diagnosis will say so again.
     */
    private void takeBack(Diagnosis found) throws InterruptedException {
        boolean isExtended = extension.belief().hasLearned();
        boolean isKnown = isExtended || !announced.isEmpty();
        if (found.isComplete() && isKnown && extension.reaches(extension.belief().unlearning())) {
            announced = List.of();
            announce(Announcement.of(found, isExtended));
        }
    }

    private void announce(ModelCorrection what) throws InterruptedException {
        toSimulator.send(List.of(new AnnounceModelCorrectionCommand(objectId, what)));
    }
}
