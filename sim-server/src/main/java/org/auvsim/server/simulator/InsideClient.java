package org.auvsim.server.simulator;

import org.auvsim.auvsml.framing.Incoming;
import org.auvsim.auvsml.message.Message;
import org.auvsim.auvsml.message.session.ErrorResponse;
import org.auvsim.server.net.ClientSession;

import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.Function;

/**
 * A client within the simulator's program, which hears of nothing but refusals. It comes when it
 * first has to say something. For the thread of whoever uses it, which waits where the mailbox is
 * full.
 */
final class InsideClient implements Consumer<List<Message>> {
    private final Mailbox mailbox;
    private final ClientSession session;
    private boolean hasCome;
    private volatile Consumer<ErrorResponse> refusals = _ -> {};

    /**
     * A client that has not come yet.
     *
     * @param sessions makes its session, given who hears answers
     */
    InsideClient(Mailbox mailbox, Function<Consumer<Message>, ClientSession> sessions) {
        this.mailbox = mailbox;
        this.session = sessions.apply(this::hear);
    }

    /** Who is told what is refused, on the simulation thread. */
    void tellRefusals(Consumer<ErrorResponse> to) {
        refusals = to;
    }

    private void hear(Message answer) {
        if (answer instanceof ErrorResponse refused) {
            refusals.accept(refused);
        }
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
