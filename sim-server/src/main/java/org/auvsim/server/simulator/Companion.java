package org.auvsim.server.simulator;

import org.auvsim.auvsml.message.feedback.FeedbackMessage;
import org.auvsim.auvsml.message.session.ErrorResponse;
import org.auvsim.server.feedback.AppliedFeedback;

/**
 * Sits beside a simulation and watches one world object. It must not hold the simulation thread up:
 * what takes time, it does on a thread of its own.
 */
public interface Companion extends AutoCloseable {
    /** Feedback for the object is used; while its step is under way. */
    void corrected(FeedbackMessage feedback, AppliedFeedback applied);

    /** A step is over, before what clients want of the next one is carried out. */
    void stepMade(StepMade step);

    /**
     * What it wanted of the simulation is refused, at once or when the past is corrected; on the
     * simulation thread.
     */
    void refused(ErrorResponse why);

    /** The simulation has ended. */
    @Override
    void close();
}
