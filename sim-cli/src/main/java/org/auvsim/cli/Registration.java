package org.auvsim.cli;

import org.auvsim.auvsml.message.command.EventType;
import org.auvsim.auvsml.message.command.ListenedObject;
import org.auvsim.auvsml.message.command.Listener;
import org.auvsim.auvsml.message.listening.ListenerRegistrationRequestCommand;

import java.util.List;

/** Requests to hear of world objects. */
final class Registration {
    /** Stands for all world objects, present and future. */
    static final String EVERY_OBJECT = "*";

    private Registration() {}

    /** For some events of an object. */
    static ListenerRegistrationRequestCommand of(String objectId, List<EventType> events) {
        return to(objectId, events.stream().map(e -> Listener.to(e.eventName())).toList());
    }

    /** For every event of an object. */
    static ListenerRegistrationRequestCommand ofAll(String objectId) {
        return to(objectId, List.of(Listener.to(Listener.ALL)));
    }

    private static ListenerRegistrationRequestCommand to(String id, List<Listener> listeners) {
        return new ListenerRegistrationRequestCommand(
                true, List.of(new ListenedObject(id, listeners)));
    }
}
