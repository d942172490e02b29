package org.auvsim.server.simulator;

import org.auvsim.auvsml.document.WhenLate;
import org.auvsim.server.feedback.AppliedFeedback;
import org.auvsim.server.feedback.FeedbackAudience;
import org.auvsim.server.feedback.ProjectedWorld;

import java.time.Duration;
import java.util.Optional;
import java.util.function.BooleanSupplier;
import java.util.function.Consumer;

/** Hears of a step that is made again: nobody is told, nobody is waited for. */
record SilentAudience(Consumer<AppliedFeedback> corrections) implements FeedbackAudience {
    @Override
    public void projected(ProjectedWorld projection) {
        // told when it was new
    }

    @Override
    public void bringFeedback(Duration wait, BooleanSupplier enough) {
        // all is known already
    }

    @Override
    public void awaitMembers(Optional<Duration> timeout, WhenLate then) {
        // all is known already
    }

    @Override
    public void advanced() {
        // the present alone is told, when it is reached
    }

    @Override
    public void moved(long objectId) {
        // likewise
    }

    @Override
    public void applied(AppliedFeedback applied) {
        corrections.accept(applied);
    }

    @Override
    public void finished() {
        // likewise
    }
}
