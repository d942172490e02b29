package org.auvsim.server.simulator;

import org.auvsim.auvsml.Role;
import org.auvsim.auvsml.framing.AuvsmlReader;
import org.auvsim.auvsml.framing.AuvsmlWriter;
import org.auvsim.auvsml.framing.Incoming;
import org.auvsim.auvsml.framing.RootDecoder;
import org.auvsim.auvsml.message.session.DisconnectedNotification;
import org.auvsim.auvsml.xml.Limits;
import org.auvsim.server.net.ClientSession;
import org.auvsim.server.net.Reception;

import java.io.InputStream;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.atomic.AtomicLong;

/** Where clients come in: brings what they do to the simulation thread. Runs on their threads. */
final class Clients implements Reception {
    private final Mailbox mailbox;
    private final RootDecoder decoder;
    private final AuvsmlWriter writer;
    private final Limits limits;
    private final Role role;
    private final AtomicLong lastId;
    private final Map<Long, ClientSession> open = new ConcurrentHashMap<>();

    Clients(
            Mailbox mailbox,
            RootDecoder decoder,
            AuvsmlWriter writer,
            Limits limits,
            Role role,
            long firstId) {
        this.mailbox = mailbox;
        this.decoder = decoder;
        this.writer = writer;
        this.limits = limits;
        this.role = role;
        this.lastId = new AtomicLong(firstId - 1);
    }

    @Override
    public AuvsmlReader reader(InputStream in) {
        return new AuvsmlReader(in, decoder, limits);
    }

    @Override
    public Optional<ClientSession> admit(String peer) throws InterruptedException {
        open.values().removeIf(ClientSession::isClosed);
        ClientSession session = new ClientSession(lastId.incrementAndGet(), peer, role, writer);
        open.put(session.id(), session);
        if (mailbox.post(new Input.Came(session))) {
            return Optional.of(session);
        }
        open.remove(session.id());
        return Optional.empty();
    }

    /** An administrator that lives within this program. */
    InsideClient inside() {
        return new InsideClient(
                mailbox,
                ear ->
                        ClientSession.within(
                                lastId.incrementAndGet(),
                                "this simulator",
                                Role.ADMIN,
                                writer,
                                ear));
    }

    @Override
    public void received(ClientSession session, Incoming incoming) throws InterruptedException {
        switch (incoming) {
            case Incoming.Request request -> mailbox.post(new Input.Sent(session, request));
            case Incoming.Rejected rejected ->
                    mailbox.post(new Input.Unreadable(session, rejected));
            case Incoming.End _ -> left(session);
        }
    }

    @Override
    public void left(ClientSession session) throws InterruptedException {
        if (!mailbox.post(new Input.Went(session))) {
            session.close();
        }
    }

    @Override
    public byte[] farewell(String reason) {
        return writer.write(new DisconnectedNotification(reason));
    }

    /** So many are connected. */
    int count() {
        return (int) open.values().stream().filter(session -> !session.isClosed()).count();
    }

    /** Ends all sessions when the simulation thread has done its work. */
    void endAll(String reason) {
        open.values().forEach(session -> session.close(reason));
    }
}
