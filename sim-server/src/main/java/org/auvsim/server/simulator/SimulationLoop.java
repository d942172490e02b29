package org.auvsim.server.simulator;

import org.auvsim.auvsml.ErrorCode;
import org.auvsim.auvsml.message.Message;
import org.auvsim.auvsml.message.command.RefusedException;
import org.auvsim.auvsml.message.command.SimulatorState;
import org.auvsim.auvsml.message.session.ErrorResponse;
import org.auvsim.auvsml.message.session.LaggingNotification;
import org.auvsim.auvsml.message.session.LaggingSide;
import org.auvsim.core.world.World;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

import java.util.List;
import java.util.OptionalDouble;
import java.util.OptionalInt;
import java.util.OptionalLong;

/** The one loop in which time goes on, on the one thread that owns the world. */
final class SimulationLoop implements TimeControl {
    private static final Logger LOG = LoggerFactory.getLogger(SimulationLoop.class);
    private static final double ROUNDING = 1e-9;

    /** So many requests are carried out before time may go on: no flood of them holds it still. */
    private static final int MOST_REQUESTS = 256;

    private final World world;
    private final Mailbox mailbox;
    private final Pace pace;
    private final Lag lag;
    private final Simulation simulation;
    private final double until;
    private boolean running;
    private int stepsAsked;

    SimulationLoop(
            SimulationSettings settings,
            Mailbox mailbox,
            Pace pace,
            boolean running,
            OptionalDouble until) {
        this.world = settings.world();
        this.mailbox = mailbox;
        this.pace = pace;
        this.lag = new Lag(pace);
        this.simulation = new Simulation(settings, mailbox, this, pace::now);
        this.running = running;
        this.until = until.orElse(Double.POSITIVE_INFINITY) - ROUNDING;
    }

    /** Runs until the mailbox is closed. */
    void run() throws InterruptedException {
        pace.start(world.time());
        while (!mailbox.isClosed()) {
            take(mailbox.take(MOST_REQUESTS, nanosUntilStep()));
            if (!mailbox.isClosed() && nanosUntilStep() <= 0) {
                advanceTimestep();
                tellLag();
            }
        }
    }

    private long nanosUntilStep() {
        if (stepsAsked > 0) {
            return 0;
        }
        return running ? pace.nanosUntil(world.time()) : Long.MAX_VALUE;
    }

    private void take(List<Input> inputs) {
        for (Input input : inputs) {
            try {
                simulation.take(input);
            } catch (RuntimeException e) {
                LOG.error("an input could not be taken", e);
                tellFailure(input);
            }
        }
    }

    /** Nobody waits for an answer in vain. */
    private static void tellFailure(Input input) {
        if (input instanceof Input.Sent(var session, var request)) {
            session.send(
                    request.requestId(),
                    List.of(
                            new ErrorResponse(
                                    ErrorCode.REFUSED,
                                    "this failed in the simulator; its log says why",
                                    OptionalInt.empty(),
                                    OptionalInt.empty())));
        }
    }

    private void advanceTimestep() {
        try {
            simulation.advanceTimestep();
            stepsAsked = Math.max(0, stepsAsked - 1);
        } catch (StepAbandonedException e) {
            LOG.debug("the last step was not made: {}", e.getMessage());
        } catch (RuntimeException e) {
            standStill(e);
        }
        if (world.time() >= until) {
            LOG.info("the world has reached {} s, where it was to end", world.time());
            shutdown();
        }
    }

    private void standStill(RuntimeException why) {
        running = false;
        stepsAsked = 0;
        String text =
                "the step at %s s failed and the simulation is paused: %s"
                        .formatted(world.time(), why.getMessage());
        LOG.error(text);
        LOG.debug("the step failed here", why);
        simulation
                .notifications()
                .toAll(
                        new ErrorResponse(
                                ErrorCode.STEP_FAILED,
                                text,
                                OptionalInt.empty(),
                                OptionalInt.empty()));
    }

    private void tellLag() {
        OptionalLong skipped =
                running ? lag.skippedSteps(world.time(), world.timeStep()) : OptionalLong.empty();
        if (skipped.isPresent()) {
            LOG.warn(
                    "too slow for {} times real time: the world's time has fallen behind by {}"
                            + " steps",
                    pace.rate().orElse(Double.POSITIVE_INFINITY),
                    skipped.getAsLong());
            simulation
                    .notifications()
                    .toAll(new LaggingNotification(LaggingSide.SIMULATOR, skipped.getAsLong()));
        }
    }

    @Override
    public void pause() {
        running = false;
        stepsAsked = 0;
    }

    @Override
    public void resume() {
        if (!running) {
            running = true;
            stepsAsked = 0;
            pace.start(world.time());
        }
    }

    @Override
    public void shutdown() {
        mailbox.close();
    }

    @Override
    public void setRate(OptionalDouble factor) {
        pace.set(factor, world.time());
    }

    @Override
    public void step(int count) {
        requirePaused();
        stepsAsked = (int) Math.min(Integer.MAX_VALUE, (long) stepsAsked + count);
    }

    @Override
    public void timeHasJumped() {
        stepsAsked = 0;
        pace.start(world.time());
    }

    /** Tells all clients. */
    void tell(Message message) {
        simulation.notifications().toAll(message);
    }

    /** Makes one step at once, while paused. */
    void stepNow() {
        requirePaused();
        advanceTimestep();
    }

    private void requirePaused() {
        if (running) {
            throw new RefusedException(
                    ErrorCode.REFUSED, "steps are made one by one only while paused; pause first");
        }
    }

    @Override
    public SimulatorState state() {
        return new SimulatorState(
                world.time(),
                running,
                pace.rate(),
                simulation.steps(),
                simulation.notifications().sessions().size());
    }
}
