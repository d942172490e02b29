package org.auvsim.server.simulator;

import org.auvsim.auvsml.framing.Incoming;
import org.auvsim.auvsml.message.Message;
import org.auvsim.auvsml.message.session.ErrorResponse;
import org.auvsim.server.net.ClientSession;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.function.Consumer;
import java.util.function.Function;

/**
 * A client within the simulator's program, which hears of nothing but what becomes of what it
 * sends. It comes when it first has to say something. For the thread of whoever uses it, which
 * waits where the mailbox is full, and for answers.
 */
final class InsideClient implements Messenger {
    private final Mailbox mailbox;
    private final ClientSession session;

    /** No more than the messages of one request, as its sender waits for all of them. */
    private final BlockingQueue<Optional<ErrorResponse>> answers = new LinkedBlockingQueue<>();

    private boolean hasCome;
    private long requests;
    private volatile Consumer<ErrorResponse> refusals = _ -> {};

    /**
     * A client that has not come yet.
     *
     * @param sessions makes its session, given who hears answers
     */
    InsideClient(Mailbox mailbox, Function<ClientSession.Ear, ClientSession> sessions) {
        this.mailbox = mailbox;
        this.session = sessions.apply(this::hear);
    }

    /** Who is told what is refused, on the simulation thread. */
    void tellRefusals(Consumer<ErrorResponse> to) {
        refusals = to;
    }

    private void hear(Optional<String> requestId, Message message) {
        Optional<ErrorResponse> refusal =
                message instanceof ErrorResponse refused ? Optional.of(refused) : Optional.empty();
        refusal.ifPresent(refusals);
        if (requestId.isPresent()) {
            answers.add(refusal);
        }
    }

    @Override
    public List<Optional<ErrorResponse>> send(List<Message> messages) throws InterruptedException {
        if (!hasCome) {
            post(new Input.Came(session));
            hasCome = true;
        }
        requests++;
        Optional<String> id = Optional.of(Long.toString(requests));
        post(new Input.Sent(session, new Incoming.Request(id, messages)));
        List<Optional<ErrorResponse>> all = new ArrayList<>();
        while (all.size() < messages.size()) {
            all.add(answers.take());
        }
        return all;
    }

    private void post(Input input) throws InterruptedException {
        if (!mailbox.post(input)) {
            throw new InterruptedException("the simulation has ended");
        }
    }
}
