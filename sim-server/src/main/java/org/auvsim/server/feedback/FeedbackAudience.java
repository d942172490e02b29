package org.auvsim.server.feedback;

import org.auvsim.auvsml.document.WhenLate;
import org.auvsim.auvsml.message.command.RefusedException;

import java.time.Duration;
import java.util.Optional;
import java.util.function.BooleanSupplier;

/** The world outside of a step: hears what happens in it and brings feedback. */
public interface FeedbackAudience {
    /** The step will end so; this is to reach the clients now. */
    void projected(ProjectedWorld projection);

    /**
     * Brings feedback, by {@link CorrectiveFeedbackSystem#take}, for so long or until enough is
     * there.
     */
    void bringFeedback(Duration wait, BooleanSupplier enough);

    /**
     * Waits until all who were members when the projection was shown have answered it, and brings
     * their feedback.
     *
     * @param timeout how long, on the wall's clock; empty: for ever
     * @param then what is done when that is over
     */
    void awaitMembers(Optional<Duration> timeout, WhenLate then);

    /** The world has made the step, as its listeners have heard. */
    void advanced();

    /** A processor has moved an object after the step, which is to be told once more. */
    void moved(long objectId);

    /** A correction is done. */
    void applied(PendingFeedback feedback, AppliedFeedback applied);

    /** A feedback that was taken cannot be used after all; its sender is to be told. */
    void refused(PendingFeedback feedback, RefusedException why);

    /** The step is over: the last message of it. */
    void finished();
}
