package org.auvsim.auvsml.message.feedback;

import org.auvsim.auvsml.message.Message;

/** What a robot measured of itself, for the Corrective Feedback System (thesis, section 7.2). */
public interface FeedbackMessage extends Message {
    /** The id of the world object that stands for the robot. */
    long worldObjectId();

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
