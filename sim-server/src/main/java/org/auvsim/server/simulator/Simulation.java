package org.auvsim.server.simulator;

import org.auvsim.auvsml.ErrorCode;
import org.auvsim.auvsml.document.FeedbackProcessorChoice;
import org.auvsim.auvsml.document.FeedbackTimestepping;
import org.auvsim.auvsml.document.ReleasedObject;
import org.auvsim.auvsml.document.Scenario;
import org.auvsim.auvsml.message.command.RefusedException;
import org.auvsim.auvsml.message.control.SnapshotRestoredNotification;
import org.auvsim.auvsml.message.feedback.HistoryRevisedNotification;
import org.auvsim.auvsml.message.learning.ModelCorrection;
import org.auvsim.core.world.World;
import org.auvsim.server.feedback.AppliedFeedback;
import org.auvsim.server.feedback.CorrectiveFeedbackSystem;
import org.auvsim.server.feedback.FeedbackProcessor;
import org.auvsim.server.feedback.FeedbackTimestepper;
import org.auvsim.server.feedback.PastStep;
import org.auvsim.server.feedback.PendingFeedback;
import org.auvsim.server.feedback.ProcessorMemory;
import org.auvsim.server.net.ClientSession;
import org.auvsim.server.net.Notifications;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.LongSupplier;

/**
 * A world with its clients, without a clock: all that happens follows from the inputs that it takes
 * and from the steps that it is told to make. Whoever gives the same inputs at the same places, as
 * a recording does, gets the same simulation, bit for bit.
 */
final class Simulation {
    private final World world;
    private final Notifications notifications;
    private final WorldNews news;
    private final ControlledObjects controlled;
    private final Members members = new Members();
    private final History history;
    private final CorrectiveFeedbackSystem feedback;
    private final Requests requests;
    private final List<InputLog> logs;

    private final Snapshots snapshots = new Snapshots();
    private SimulationState beginning;

    /** Commands of members that are carried out when the step that is under way is made. */
    private final List<Held> answers = new ArrayList<>();

    /** Feedback of the step that is under way, or was made last, that could not be used. */
    private final List<PendingFeedback> refused = new ArrayList<>();

    private long steps;
    private int inputs;
    private int revision;
    private boolean stepIsUnderWay;

    /**
     * A simulation at its beginning.
     *
     * @param source where a step that waits gets inputs from
     * @param time what decides when a step is made
     * @param nanoClock by which steps wait (ns)
     */
    Simulation(
            SimulationSettings settings,
            InputSource source,
            TimeControl time,
            LongSupplier nanoClock) {
        world = settings.world();
        logs = settings.logs();
        notifications = new Notifications(settings.writer());
        news = new WorldNews(world, notifications);
        history = new History(settings.horizon());
        controlled = new ControlledObjects(world, history, settings.released());
        feedback =
                new CorrectiveFeedbackSystem(
                        world,
                        settings.timestepper(),
                        settings.processors(),
                        new StepAudience(this, source, nanoClock, news));
        requests =
                new Requests(
                        notifications,
                        members,
                        new Execution(
                                new WorldPort(world, new DescriptionLimits(settings.writer())),
                                controlled,
                                feedback,
                                members,
                                history,
                                notifications,
                                new SimulatorPort(this, time)),
                        settings.serverName());
        world.addListener(news);
        world.addListener(controlled);
        beginning = state();
        logs.forEach(log -> log.begun(world));
    }

    World world() {
        return world;
    }

    Notifications notifications() {
        return notifications;
    }

    Members members() {
        return members;
    }

    /** Number of steps made. */
    long steps() {
        return steps;
    }

    /** Takes an input. */
    void take(Input input) {
        InputPlace place = place();
        logs.forEach(log -> log.taken(place, input));
        inputs++;
        requests.take(input);
    }

    private InputPlace place() {
        return new InputPlace(revision, steps, inputs, stepIsUnderWay, world.time());
    }

    /**
     * Makes a step, after the past is corrected if late feedback asks for that.
     *
     * @throws RuntimeException if the world cannot make it
     */
    void advanceTimestep() {
        reviseHistory();
        members.takeOpenings().forEach(requests::carryOut);
        stepIsUnderWay = true;
        requests.stepBegins();
        boolean made = false;
        try {
            makeStep();
            made = true;
        } finally {
            stepIsUnderWay = false;
            if (made) {
                stepIsMade();
            } else {
                InputPlace place = place();
                logs.forEach(log -> log.stepFailed(place));
            }
            List<Held> now = List.copyOf(answers);
            answers.clear();
            requests.stepEnds(now);
        }
    }

    private void makeStep() {
        if (!history.isKept()) {
            feedback.advanceTimestep();
            return;
        }
        double wanted = world.timeStep();
        double start = world.time();
        SimulationState before = state();
        refused.clear();
        feedback.advanceTimestep();
        List<PendingFeedback> used = new ArrayList<>(feedback.takenInStep());
        used.removeAll(refused);
        history.add(before, new PastStep(start, wanted, world.time()), used);
        feedback.reachBackTo(history.reachesBackTo());
    }

    private void stepIsMade() {
        steps++;
        inputs = 0;
        members.stepsMade(steps);
        logs.forEach(log -> log.stepMade(new StepMade(revision, steps, world)));
    }

    /** A feedback that was taken for the step cannot be used. */
    void refused(PendingFeedback feedback) {
        refused.add(feedback);
    }

    /** A feedback is used. */
    void corrected(PendingFeedback feedback, AppliedFeedback applied) {
        logs.forEach(log -> log.corrected(world, feedback, applied));
        news.applied(applied);
    }

    /** Clients are shown where the step will end. */
    void shown() {
        members.stepShown();
    }

    /** The members have answered: their feedback is used now, their commands after the step. */
    void takeAnswers() {
        Members.Answers taken = members.takeAnswers();
        taken.feedback().forEach(requests::carryOut);
        answers.addAll(taken.commands());
    }

    /** All that the simulation goes on from, as it is between two steps. */
    SimulationState state() {
        return new SimulationState(
                world.copy(), controlled.holders(), feedback.pending(), feedback.memory());
    }

    /** Goes on from there, but for who controls what: that is of the present. */
    void restoreWorld(SimulationState state) {
        world.restore(state.world());
        feedback.restore(state.pending(), state.memory());
    }

    /** Makes steps in another way from the next one on. */
    void setTimestepper(FeedbackTimestepping choice) {
        use(ScenarioSettings.timestepper(choice));
    }

    private void use(FeedbackTimestepper timestepper) {
        feedback.setTimestepper(timestepper);
        if (timestepper.isLockstep()) {
            notifications.sessions().stream().filter(ClientSession::hasName).forEach(members::join);
        } else {
            members.dissolve().forEach(requests::carryOut);
        }
    }

    /** Lets one processor do all corrections, or each that a message names. */
    void setFeedbackProcessor(Optional<String> name) {
        name.ifPresentOrElse(feedback.processors()::override, feedback.processors()::overrideNone);
    }

    /** Tells those who listen what was found that the model of a world object lacks. */
    void announce(long worldObjectId, ModelCorrection correction) {
        news.found(WorldPort.object(world, worldObjectId).id(), correction);
    }

    ConnectedClients clients() {
        return new ConnectedClients(notifications, controlled, members);
    }

    /** Ends the session of a client, which is told the reason. */
    void disconnect(ClientSession client, String reason) {
        requests.disconnect(client, reason);
    }

    Snapshots snapshots() {
        return snapshots;
    }

    void takeSnapshot(String name) {
        snapshots.keep(name, state());
    }

    void restoreSnapshot(String name) {
        goTo(snapshots.named(name), name);
    }

    /** Goes back to how the scenario began; sessions go on, and control nothing. */
    void reset() {
        goTo(beginning, "*BEGINNING*");
    }

    /**
     * Goes on with the world of another scenario, in the way that it states.
     *
     * @throws RefusedException if there is something in it that this simulator does not have; then
     *     nothing has changed
     */
    void load(Scenario scenario) {
        FeedbackTimestepper timestepper =
                ScenarioSettings.timestepper(scenario.feedbackTimestepping());
        Optional<FeedbackProcessorChoice> choice = scenario.feedbackProcessor();
        List<FeedbackProcessor> processors =
                choice.map(ScenarioSettings::processors).orElse(List.of());
        World other = scenario.world();
        feedback.processors()
                .configure(processors, choice.flatMap(FeedbackProcessorChoice::override));
        use(timestepper);
        history.setHorizon(scenario.feedbackHorizon());
        controlled.setReleased(scenario.releasedObject().orElse(ReleasedObject.UNCHANGED));
        goTo(new SimulationState(other, Map.of(), List.of(), new ProcessorMemory()), "*SCENARIO*");
        beginning = state();
    }

    private void goTo(SimulationState state, String name) {
        Set<Long> known = news.entityIds();
        refuseLate(feedback.takeLate(), "the world has gone elsewhere");
        restoreWorld(state);
        controlled.restore(state.holders());
        controlled.retain(notifications.sessions());
        history.clear();
        feedback.reachBackTo(history.reachesBackTo());
        revision++;
        notifications.toAll(new SnapshotRestoredNotification(revision, world.time(), name));
        news.present(known);
        news.flush();
    }

    /**
     * Goes back to where late feedback is true, and makes the steps from there to now again. If
     * they cannot be made with it, everything stays as it is.
     */
    private void reviseHistory() {
        List<PendingFeedback> late = new ArrayList<>(feedback.takeLate());
        List<PendingFeedback> tooLate =
                late.stream().filter(l -> !history.reaches(l.message().timestamp())).toList();
        refuseLate(tooLate, "it is older than the past that is kept");
        late.removeAll(tooLate);
        if (late.isEmpty()) {
            return;
        }
        SimulationState now = state();
        Set<Long> known = news.entityIds();
        Revision made = new Revision(this, feedback, requests, history.from(late), late);
        try {
            news.silently(made::make);
        } catch (RuntimeException e) {
            restoreWorld(now);
            made.refuse(e);
            return;
        }
        if (made.corrections().isEmpty()) {
            restoreWorld(now); // none could be used, so nothing has changed
            made.tellRefused();
            return;
        }
        revision++;
        history.replaceLast(made.again());
        notifications.toAll(new HistoryRevisedNotification(revision, made.from(), world.time()));
        made.corrections().forEach(this::corrected);
        made.tellRefused();
        news.present(known);
        news.flush();
    }

    private static void refuseLate(List<PendingFeedback> late, String why) {
        for (PendingFeedback one : late) {
            one.sender()
                    .refused(
                            new RefusedException(
                                    ErrorCode.REFUSED,
                                    "feedback for %s s cannot be used any more: %s"
                                            .formatted(one.message().timestamp(), why)));
        }
    }
}
