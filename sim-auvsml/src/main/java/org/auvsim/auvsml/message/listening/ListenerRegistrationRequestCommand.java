package org.auvsim.auvsml.message.listening;

import org.auvsim.auvsml.message.Message;
import org.auvsim.auvsml.message.command.ClientCommand;
import org.auvsim.auvsml.message.command.ListenedObject;
import org.auvsim.auvsml.message.command.SessionControl;

import java.util.List;
import java.util.Optional;

/**
 * Registers the sender for events of world objects, or ends registrations (thesis, appendix A.1).
 *
 * @param register whether to begin (1) or to end (0) them
 */
public record ListenerRegistrationRequestCommand(boolean register, List<ListenedObject> worldObject)
        implements ClientCommand {
    @Override
    public Optional<Message> execute(SessionControl session) {
        if (register) {
            session.register(worldObject);
        } else {
            session.unregister(worldObject);
        }
        return Optional.empty();
    }
}
