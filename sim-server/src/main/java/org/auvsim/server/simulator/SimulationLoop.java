package org.auvsim.server.simulator;

import org.auvsim.auvsml.ErrorCode;
import org.auvsim.auvsml.message.command.RefusedException;
import org.auvsim.auvsml.message.command.SimulatorControl;
import org.auvsim.auvsml.message.command.SimulatorState;
import org.auvsim.auvsml.message.session.ErrorResponse;
import org.auvsim.auvsml.message.session.LaggingNotification;
import org.auvsim.auvsml.message.session.LaggingSide;
import org.auvsim.core.world.World;
import org.auvsim.server.feedback.CorrectiveFeedbackSystem;
import org.auvsim.server.net.Notifications;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

import java.util.List;
import java.util.OptionalDouble;
import java.util.OptionalInt;
import java.util.OptionalLong;

/** The one loop in which time goes on, on the one thread that owns the world. */
final class SimulationLoop implements SimulatorControl {
    private static final Logger LOG = LoggerFactory.getLogger(SimulationLoop.class);
    private static final double ROUNDING = 1e-9;

    /** So many requests are carried out before time may go on: no flood of them holds it still. */
    private static final int MOST_REQUESTS = 256;

    private final World world;
    private final Mailbox mailbox;
    private final Notifications notifications;
    private final Pace pace;
    private final Lag lag;
    private final CorrectiveFeedbackSystem feedback;
    private final double until;
    private boolean running;
    private int stepsAsked;
    private long steps;

    SimulationLoop(
            World world,
            Mailbox mailbox,
            Notifications notifications,
            Pace pace,
            CorrectiveFeedbackSystem feedback,
            boolean running,
            OptionalDouble until) {
        this.world = world;
        this.mailbox = mailbox;
        this.notifications = notifications;
        this.pace = pace;
        this.lag = new Lag(pace, world.timeStep());
        this.feedback = feedback;
        this.running = running;
        this.until = until.orElse(Double.POSITIVE_INFINITY) - ROUNDING;
    }

    /** Runs until the mailbox is closed. */
    void run() throws InterruptedException {
        pace.start(world.time());
        while (!mailbox.isClosed()) {
            carryOut(mailbox.take(MOST_REQUESTS, nanosUntilStep()));
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

    private void carryOut(List<Runnable> tasks) {
        for (Runnable task : tasks) {
            try {
                task.run();
            } catch (RuntimeException e) {
                LOG.error("a request failed", e);
            }
        }
    }

    private void advanceTimestep() {
        try {
            feedback.advanceTimestep();
            steps++;
            stepsAsked = Math.max(0, stepsAsked - 1);
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
        notifications.toAll(
                new ErrorResponse(
                        ErrorCode.STEP_FAILED, text, OptionalInt.empty(), OptionalInt.empty()));
    }

    private void tellLag() {
        OptionalLong skipped = running ? lag.skippedSteps(world.time()) : OptionalLong.empty();
        if (skipped.isPresent()) {
            LOG.warn(
                    "too slow for {} times real time: {} steps skipped",
                    pace.rate().orElse(Double.POSITIVE_INFINITY),
                    skipped.getAsLong());
            notifications.toAll(
                    new LaggingNotification(LaggingSide.SIMULATOR, skipped.getAsLong()));
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
                world.time(), running, pace.rate(), steps, notifications.sessions().size());
    }
}
