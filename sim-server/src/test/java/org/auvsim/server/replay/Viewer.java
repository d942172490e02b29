package org.auvsim.server.replay;

import static java.nio.charset.StandardCharsets.UTF_8;

import org.auvsim.auvsml.framing.Incoming;
import org.auvsim.auvsml.message.Message;
import org.auvsim.server.net.ClientSession;
import org.auvsim.server.net.Reception;
import org.auvsim.server.net.Transport;

import java.util.List;
import java.util.Optional;

/** A viewer that is there, and has sent its messages, before the first step. */
final class Viewer implements Transport {
    private final List<Message> messages;
    private Optional<ClientSession> session = Optional.empty();

    Viewer(Message... messages) {
        this.messages = List.of(messages);
    }

    @Override
    public void open(Reception reception) {
        try {
            session = reception.admit("viewer");
            for (Message message : messages) {
                reception.received(
                        session.orElseThrow(),
                        new Incoming.Request(Optional.of("r"), List.of(message)));
            }
        } catch (InterruptedException e) {
            throw new IllegalStateException(e);
        }
    }

    /** All that was sent to it, up to the end of its session. */
    String heard() throws InterruptedException {
        StringBuilder heard = new StringBuilder();
        for (Optional<byte[]> next = session.orElseThrow().nextBytes();
                next.isPresent();
                next = session.orElseThrow().nextBytes()) {
            heard.append(new String(next.get(), UTF_8));
        }
        return heard.toString();
    }

    @Override
    public void close() {
        // the session is closed by the simulation
    }
}
