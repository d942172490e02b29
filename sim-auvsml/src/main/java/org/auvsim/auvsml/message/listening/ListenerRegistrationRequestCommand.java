package org.auvsim.auvsml.message.listening;

import org.auvsim.auvsml.message.Message;
import org.auvsim.auvsml.message.command.ClientCommand;
import org.auvsim.auvsml.message.command.EventType;
import org.auvsim.auvsml.message.command.ListenedObject;
import org.auvsim.auvsml.message.command.Listener;
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
    /** Registers for events of a world object, or of {@link ListenedObject#EVERY} one. */
    public static ListenerRegistrationRequestCommand of(String objectId, List<EventType> events) {
        return to(objectId, events.stream().map(e -> Listener.to(e.eventName())).toList());
    }

    /** Registers for all events of a world object, or of {@link ListenedObject#EVERY} one. */
    public static ListenerRegistrationRequestCommand ofAll(String objectId) {
        return to(objectId, List.of(Listener.to(Listener.ALL)));
    }

    private static ListenerRegistrationRequestCommand to(String id, List<Listener> listeners) {
        return new ListenerRegistrationRequestCommand(
                true, List.of(new ListenedObject(id, listeners)));
    }

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
