package org.auvsim.auvsml.message.feedback;

import org.auvsim.auvsml.message.WorldObjectMessage;

/** What a robot measured of itself, for the Corrective Feedback System (thesis, section 7.2). */
public interface FeedbackMessage extends WorldObjectMessage {
    /**
     * The world's time (s) for which the measurement holds: that of a projected movement, or one
     * within its step.
     */
    double timestamp();

    /** The name of the feedback processor that is to use it; the server may choose another. */
    String handlerName();

    /** What was measured. */
    Measurement measurement();
}
