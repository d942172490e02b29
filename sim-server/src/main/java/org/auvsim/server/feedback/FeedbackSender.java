package org.auvsim.server.feedback;

import org.auvsim.auvsml.message.command.RefusedException;

/** Who sent a feedback. */
public interface FeedbackSender {
    /** The client's name. */
    String name();

    /** Tells the client that its feedback could not be used after all. */
    void refused(RefusedException why);
}
