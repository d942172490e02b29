package org.auvsim.server.simulator;

import org.auvsim.auvsml.framing.Incoming;
import org.auvsim.auvsml.message.Message;
import org.auvsim.server.net.ClientSession;

import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;

/**
 * A client within the simulator's program, which hears nothing. It comes when it first has to say
 * something. For the thread of whoever uses it, which waits where the mailbox is full.
 */
final class InsideClient implements Consumer<List<Message>> {
    private final Mailbox mailbox;
    private final ClientSession session;
    private boolean hasCome;

    InsideClient(Mailbox mailbox, ClientSession session) {
        this.mailbox = mailbox;
        this.session = session;
        session.close();
    }

    @Override
    public void accept(List<Message> messages) {
        try {
            if (!hasCome) {
                hasCome = mailbox.post(new Input.Came(session));
            }
            mailbox.post(new Input.Sent(session, new Incoming.Request(Optional.empty(), messages)));
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }
}
