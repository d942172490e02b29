package org.auvsim.server.simulator;

import org.auvsim.auvsml.document.WhenLate;
import org.auvsim.auvsml.message.command.RefusedException;
import org.auvsim.server.feedback.AppliedFeedback;
import org.auvsim.server.feedback.FeedbackAudience;
import org.auvsim.server.feedback.PendingFeedback;
import org.auvsim.server.feedback.ProjectedWorld;

import java.time.Duration;
import java.util.IdentityHashMap;
import java.util.Map;
import java.util.Optional;
import java.util.function.BooleanSupplier;

/**
 * Hears of a step that is made again: nobody is told of it yet, and nobody is waited for.
 *
 * @param applied what each feedback came to
 * @param refused why others could not be used
 */
record SilentAudience(
        Map<PendingFeedback, AppliedFeedback> applied,
        Map<PendingFeedback, RefusedException> refused)
        implements FeedbackAudience {
    /** Has heard nothing yet. */
    SilentAudience() {
        this(new IdentityHashMap<>(), new IdentityHashMap<>());
    }

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
    public void applied(PendingFeedback feedback, AppliedFeedback correction) {
        applied.put(feedback, correction);
    }

    @Override
    public void refused(PendingFeedback feedback, RefusedException why) {
        refused.put(feedback, why);
    }

    @Override
    public void finished() {
        // likewise
    }
}
