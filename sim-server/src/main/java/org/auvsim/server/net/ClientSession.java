package org.auvsim.server.net;

import org.auvsim.auvsml.Role;
import org.auvsim.auvsml.framing.AuvsmlWriter;
import org.auvsim.auvsml.message.Message;
import org.auvsim.auvsml.message.command.ListenedObject;
import org.auvsim.auvsml.message.session.DisconnectedNotification;
import org.auvsim.auvsml.message.session.LaggingNotification;
import org.auvsim.auvsml.message.session.LaggingSide;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.regex.Pattern;

/**
 * One client's session: who it is, what it hears, what is on its way to it. But for what {@link
 * Transport transports} use, it belongs to the simulation thread.
 */
public final class ClientSession {
    private static final Pattern GIVEN_NAME = Pattern.compile("client [0-9]+");
    private static final int MOST_STATES = 4096;
    private static final int MOST_CONTROL = 4096;
    private static final int MOST_CONTROL_MIB = 16;

    private final long id;
    private final String peer;
    private volatile String name;
    private boolean hasName;
    private boolean inLockstep;
    private final Role role;
    private final AuvsmlWriter writer;
    private final boolean ofThePast;
    private final Optional<Ear> ear;
    private final Outbox outbox =
            new Outbox(MOST_STATES, MOST_CONTROL, (long) MOST_CONTROL_MIB << 20);
    private final Registrations registrations = new Registrations();
    private final List<Delivery> pending = new ArrayList<>();

    /**
     * A session that has just begun.
     *
     * @param id unique among all sessions of a simulator
     * @param peer where the client is, as {@code 127.0.0.1:51234}
     * @param role what the client may do
     */
    public ClientSession(long id, String peer, Role role, AuvsmlWriter writer) {
        this(id, peer, role, writer, /* ofThePast= */ false, Optional.empty());
    }

    private ClientSession(
            long id,
            String peer,
            Role role,
            AuvsmlWriter writer,
            boolean ofThePast,
            Optional<Ear> ear) {
        this.id = id;
        this.peer = peer;
        this.name = givenName(id);
        this.role = role;
        this.writer = writer;
        this.ofThePast = ofThePast;
        this.ear = ear;
    }

    /** That of a client that there once was: what is sent to it goes nowhere. */
    public static ClientSession ofThePast(long id, String peer, Role role, AuvsmlWriter writer) {
        ClientSession session =
                new ClientSession(id, peer, role, writer, /* ofThePast= */ true, Optional.empty());
        session.close();
        return session;
    }

    /** Hears what is sent to a client within this program, on the simulation thread. */
    @FunctionalInterface
    public interface Ear {
        /** A message; with the id of the client's request that it answers, if it does. */
        void hear(Optional<String> requestId, Message message);
    }

    /** That of a client within this program, which registers for nothing. */
    public static ClientSession within(
            long id, String peer, Role role, AuvsmlWriter writer, Ear ear) {
        return new ClientSession(id, peer, role, writer, /* ofThePast= */ false, Optional.of(ear));
    }

    /** Whether its client was there once, in the run that is replayed, and not now. */
    public boolean isOfThePast() {
        return ofThePast;
    }

    /** What a client is called that has not said what it is called. */
    public static String givenName(long id) {
        return "client " + id;
    }

    /** Whether a client is called so, or may be some day, by the number of its session. */
    public static boolean isGiven(String name) {
        return GIVEN_NAME.matcher(name).matches();
    }

    /** Its number, unique among all sessions of a simulator. */
    public long id() {
        return id;
    }

    /** Where the client is, as {@code 127.0.0.1:51234}. */
    public String peer() {
        return peer;
    }

    /** What it may do. */
    public Role role() {
        return role;
    }

    /** What others may call the client: as it said hello, else as {@code client 3}. */
    public String name() {
        return name;
    }

    /** Whether the client has said what it is called. */
    public boolean hasName() {
        return hasName;
    }

    /** The client has said what it is called. */
    public void setName(String name) {
        this.name = name;
        hasName = true;
    }

    /** Whether it has ended; what is sent to it then goes nowhere, and is not worth making. */
    public boolean isClosed() {
        return outbox.isClosed();
    }

    /** Begins to send the events of an object. */
    public void register(ListenedObject object) {
        registrations.register(object);
    }

    /** Ends to send the events of an object. */
    public void unregister(ListenedObject object) {
        registrations.unregister(object);
    }

    /** Whether the client has registered for this object by its id. */
    public boolean isRegisteredFor(long objectId) {
        return registrations.names(objectId);
    }

    boolean wants(Topic topic, double time) {
        return registrations.wants(topic, time);
    }

    /** Whether the client answers every step, and so has to hear of every one. */
    public void setInLockstep(boolean inLockstep) {
        this.inLockstep = inLockstep;
    }

    /** Sends this with the next batch; what may be replaced by newer states is left out first. */
    void append(byte[] message, Optional<Topic> replaced) {
        pending.add(
                replaced.isPresent() && !inLockstep
                        ? Delivery.state(message, replaced.get())
                        : Delivery.control(message));
    }

    void flush() {
        offer(List.copyOf(pending));
        pending.clear();
    }

    /**
     * Sends messages in one root element, which bears the request's id; they are never left out.
     */
    public void send(Optional<String> requestId, List<? extends Message> messages) {
        if (ear.isPresent()) {
            messages.forEach(message -> ear.get().hear(requestId, message));
            return;
        }
        flush();
        offer(List.of(Delivery.control(writer.write(requestId, messages))));
    }

    /** Sends a message, which is never left out. */
    public void send(Message message) {
        send(Optional.empty(), List.of(message));
    }

    private void offer(List<Delivery> batch) {
        if (!outbox.offer(batch)) {
            outbox.abort(
                    farewell(
                            "more than %d messages, or %d MiB of them, wait for this client; read them faster"
                                    .formatted(MOST_CONTROL, MOST_CONTROL_MIB)));
        }
    }

    /** Ends the session after what waits; the last message states the reason. */
    public void close(String reason) {
        flush();
        offer(List.of(Delivery.control(farewell(reason))));
        outbox.close();
    }

    /** Ends the session after what waits. */
    public void close() {
        flush();
        outbox.close();
    }

    private byte[] farewell(String reason) {
        return writer.write(new DisconnectedNotification(reason));
    }

    /**
     * Waits for bytes to send; for the client's writer.
     *
     * @return empty when the session is over and all is sent
     */
    public Optional<byte[]> nextBytes() throws InterruptedException {
        return outbox.take().map(this::join);
    }

    private byte[] join(Outbox.Packet packet) {
        List<byte[]> messages = new ArrayList<>(packet.messages());
        if (packet.skipped() > 0) {
            messages.addFirst(
                    writer.write(new LaggingNotification(LaggingSide.CLIENT, packet.skipped())));
        }
        byte[] joined = new byte[messages.stream().mapToInt(m -> m.length).sum()];
        int end = 0;
        for (byte[] message : messages) {
            System.arraycopy(message, 0, joined, end, message.length);
            end += message.length;
        }
        return joined;
    }

    @Override
    public String toString() {
        return name() + " (" + peer + ")";
    }
}
