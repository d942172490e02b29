package org.auvsim.server.simulator;

import org.auvsim.auvsml.message.command.RefusedException;
import org.auvsim.auvsml.message.session.ErrorResponse;
import org.auvsim.server.feedback.FeedbackSender;
import org.auvsim.server.net.ClientSession;

/** The client that sent a feedback. */
record SessionSender(ClientSession session) implements FeedbackSender {
    @Override
    public String name() {
        return session.name();
    }

    @Override
    public void refused(RefusedException why) {
        session.send(ErrorResponse.of(why));
    }
}
