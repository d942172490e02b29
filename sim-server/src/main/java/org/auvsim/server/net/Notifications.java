package org.auvsim.server.net;

import org.auvsim.auvsml.framing.AuvsmlWriter;
import org.auvsim.auvsml.message.Message;
import org.auvsim.auvsml.message.command.EventType;

import java.util.Collection;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Supplier;

/**
 * Brings events to the sessions that want them. A message is made and encoded once, and only if
 * somebody wants it. Belongs to the simulation thread.
 */
public final class Notifications {
    private final AuvsmlWriter writer;
    private final Map<Long, ClientSession> sessions = new LinkedHashMap<>();

    /** Without sessions. */
    public Notifications(AuvsmlWriter writer) {
        this.writer = writer;
    }

    /** The sessions that are open, in order of their beginning; a view. */
    public Collection<ClientSession> sessions() {
        return Collections.unmodifiableCollection(sessions.values());
    }

    /** Adds a session, which hears from now on what it registers for. */
    public void add(ClientSession session) {
        sessions.put(session.id(), session);
    }

    /** Removes a session. */
    public void remove(ClientSession session) {
        sessions.remove(session.id());
    }

    /** Tells of a state of an entity, which a newer one of the same type replaces. */
    public void state(EventType type, long entityId, double time, Supplier<Message> message) {
        Topic topic = new Topic(type, entityId);
        tell(List.of(topic), time, Optional.of(topic), message);
    }

    /**
     * Tells that a step is done; a newer one replaces it, together with the movements it closes.
     *
     * @param closes the type of those movements
     */
    public void stepAdvanced(EventType closes, double time, Supplier<Message> message) {
        Topic topic = new Topic(EventType.TIMESTEP_ADVANCED, Topic.NOBODY);
        Topic replaced = new Topic(closes, Topic.NOBODY);
        tell(List.of(topic), time, Optional.of(replaced), message);
    }

    /** Tells how a step was kept from getting stuck or diverging; a newer one replaces it. */
    public void stepReported(double time, Supplier<Message> message) {
        state(EventType.STEP_REPORT, Topic.NOBODY, time, message);
    }

    /** Tells of an event of some entities, which is never left out. */
    public void event(
            EventType type, List<Long> entityIds, double time, Supplier<Message> message) {
        List<Topic> topics = entityIds.stream().map(id -> new Topic(type, id)).toList();
        tell(topics, time, Optional.empty(), message);
    }

    /** Tells; a newer message on the topic {@code replaced}, if there is one, replaces this one. */
    private void tell(
            List<Topic> topics, double time, Optional<Topic> replaced, Supplier<Message> message) {
        Optional<byte[]> bytes = Optional.empty();
        for (ClientSession session : sessions.values()) {
            if (topics.stream().anyMatch(topic -> session.wants(topic, time))) {
                if (bytes.isEmpty()) {
                    bytes = Optional.of(writer.write(message.get()));
                }
                session.append(bytes.get(), replaced);
            }
        }
    }

    /** Sends what was told since the last time, as one batch a session. */
    public void flush() {
        sessions.values().forEach(ClientSession::flush);
    }

    /** Sends a message to every session, registered or not; it is never left out. */
    public void toAll(Message message) {
        sessions.values().forEach(session -> session.send(message));
    }
}
