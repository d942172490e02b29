package org.auvsim.auvsml.message.session;

import org.auvsim.auvsml.message.Message;
import org.auvsim.auvsml.message.command.ClientCommand;
import org.auvsim.auvsml.message.command.SessionControl;

import java.util.Optional;

/** Ends the session; what is on its way to the client is still sent. */
public record DisconnectCommand() implements ClientCommand {
    @Override
    public Optional<Message> execute(SessionControl session) {
        session.disconnect();
        return Optional.empty();
    }
}
