package org.auvsim.server.simulator;

import org.auvsim.server.feedback.AppliedFeedback;
import org.auvsim.server.feedback.FeedbackAudience;
import org.auvsim.server.feedback.ProjectedWorld;
import org.auvsim.server.net.Notifications;

import java.time.Duration;
import java.util.Optional;
import java.util.function.BooleanSupplier;

/** The clients, as a step sees them. */
record StepAudience(WorldNews news, Notifications notifications, Mailbox mailbox, Pace pace)
        implements FeedbackAudience {
    @Override
    public void projected(ProjectedWorld projection) {
        news.projected(projection);
        notifications.flush();
    }

    @Override
    public void bringFeedback(Duration wait, BooleanSupplier enough) {
        long end = pace.now() + wait.toNanos();
        try {
            for (long left = wait.toNanos();
                    left > 0 && !enough.getAsBoolean() && !mailbox.isClosed();
                    left = end - pace.now()) {
                Optional<Runnable> feedback = mailbox.takeFeedback(left);
                feedback.ifPresent(Runnable::run);
            }
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
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
    public void applied(AppliedFeedback applied) {
        news.applied(applied);
    }

    @Override
    public void finished() {
        news.finished();
        notifications.flush();
    }
}
