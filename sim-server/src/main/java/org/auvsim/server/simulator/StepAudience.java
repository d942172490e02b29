package org.auvsim.server.simulator;

import org.auvsim.auvsml.document.WhenLate;
import org.auvsim.auvsml.message.command.RefusedException;
import org.auvsim.server.feedback.AppliedFeedback;
import org.auvsim.server.feedback.FeedbackAudience;
import org.auvsim.server.feedback.PendingFeedback;
import org.auvsim.server.feedback.ProjectedWorld;

import java.time.Duration;
import java.util.Optional;
import java.util.function.BooleanSupplier;
import java.util.function.LongSupplier;

/** The clients, as a step sees them. */
final class StepAudience implements FeedbackAudience {
    private static final long FOR_EVER = Long.MAX_VALUE / 2;

    private final Simulation simulation;
    private final InputSource source;
    private final LongSupplier nanoClock;
    private final WorldNews news;

    /** What the simulation tells by {@code news}, and brings from {@code source}. */
    StepAudience(
            Simulation simulation, InputSource source, LongSupplier nanoClock, WorldNews news) {
        this.simulation = simulation;
        this.source = source;
        this.nanoClock = nanoClock;
        this.news = news;
    }

    @Override
    public void projected(ProjectedWorld projection) {
        news.projected(projection);
        news.flush();
        simulation.shown();
    }

    @Override
    public void bringFeedback(Duration wait, BooleanSupplier enough) {
        waitFor(wait.toNanos(), enough);
    }

    @Override
    public void awaitMembers(Optional<Duration> timeout, WhenLate then) {
        Members members = simulation.members();
        members.setWhenLate(then);
        while (!waitFor(timeout.map(Duration::toNanos).orElse(FOR_EVER), members::haveAnswered)) {
            if (source.isClosed()) {
                throw new StepAbandonedException();
            }
            simulation.take(new Input.TimedOut());
        }
        simulation.takeAnswers();
    }

    /** Takes inputs for so long (ns), or until there are enough: then true. */
    private boolean waitFor(long nanos, BooleanSupplier enough) {
        long end = nanoClock.getAsLong() + nanos;
        try {
            for (long left = nanos;
                    left > 0 && !enough.getAsBoolean() && !source.isClosed();
                    left = end - nanoClock.getAsLong()) {
                source.next(left).ifPresent(simulation::take);
            }
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            throw new StepAbandonedException();
        }
        return enough.getAsBoolean();
    }

    @Override
    public void advanced() {
        news.advanced();
    }

    @Override
    public void moved(long objectId) {
        news.moved(objectId);
    }

    @Override
    public void applied(PendingFeedback feedback, AppliedFeedback applied) {
        simulation.corrected(feedback, applied);
    }

    @Override
    public void refused(PendingFeedback feedback, RefusedException why) {
        simulation.refused(feedback);
        feedback.sender().refused(why);
    }

    @Override
    public void finished() {
        news.finished();
        news.flush();
    }
}
