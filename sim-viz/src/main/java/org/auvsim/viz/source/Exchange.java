package org.auvsim.viz.source;

import org.auvsim.auvsml.AuvsmlException;
import org.auvsim.auvsml.client.AuvsmlClient;
import org.auvsim.auvsml.client.ConnectionException;
import org.auvsim.auvsml.client.TooLongException;
import org.auvsim.auvsml.mapping.MessageCatalogue;
import org.auvsim.auvsml.message.Message;
import org.auvsim.auvsml.message.session.DisconnectedNotification;
import org.auvsim.auvsml.message.session.ErrorResponse;

import java.util.Map;
import java.util.Optional;
import java.util.concurrent.ArrayBlockingQueue;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.Executor;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.RejectedExecutionException;
import java.util.concurrent.ThreadPoolExecutor;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicLong;
import java.util.function.Consumer;

/** One connection: questions out, answers and news in. */
final class Exchange {
    /** So many orders wait at most until they are written, */
    static final int MOST_WAITING = 256;

    /** and so many more that stop something: what is left out of them would push for ever. */
    private static final int MORE_STOPS = 256;

    private static final String FULL =
            "The simulator does not take what it is sent: %d orders wait, and this one is left out."
                    .formatted(MOST_WAITING);

    private static final String ENDED = "The connection to the simulator has ended.";

    private final AuvsmlClient client;
    private final MessageCatalogue catalogue;
    private final Map<String, CompletableFuture<Message>> open = new ConcurrentHashMap<>();
    private final AtomicLong asked = new AtomicLong();
    private final BlockingQueue<Runnable> waiting =
            new ArrayBlockingQueue<>(MOST_WAITING + MORE_STOPS);
    private final ExecutorService writer =
            new ThreadPoolExecutor(
                    1,
                    1,
                    0,
                    TimeUnit.SECONDS,
                    waiting,
                    Thread.ofVirtual().name("viewer writes").factory());
    private volatile boolean ended;

    /** Over a connection whose simulator may send the messages of a catalogue, and others. */
    Exchange(AuvsmlClient client, MessageCatalogue catalogue) {
        this.client = client;
        this.catalogue = catalogue;
    }

    AuvsmlClient client() {
        return client;
    }

    /** Sends a question; its answer comes while {@link #read} runs. */
    CompletableFuture<Message> ask(Message message) {
        return ask(message, Runnable::run);
    }

    /**
     * Sends a question in turn with others, on a thread of this connection's: a simulator that does
     * not read lets nobody wait. Of too many orders those are left out that stop nothing.
     */
    CompletableFuture<Message> post(Message message) {
        return ask(message, Stops.is(message) ? writer : this::queue);
    }

    private CompletableFuture<Message> ask(Message message, Executor by) {
        String id = "view-" + asked.incrementAndGet();
        CompletableFuture<Message> answer = new CompletableFuture<>();
        open.put(id, answer);
        try {
            by.execute(() -> write(id, message));
        } catch (RejectedExecutionException e) {
            fail(id, writer.isShutdown() ? new LostException(ENDED) : new RefusedException(FULL));
        }
        if (ended) {
            fail(id, new LostException(ENDED));
        }
        return answer;
    }

    private void queue(Runnable order) {
        if (waiting.size() >= MOST_WAITING) {
            throw new RejectedExecutionException(FULL);
        }
        writer.execute(order);
    }

    private void write(String id, Message message) {
        try {
            client.request(id, message);
        } catch (TooLongException e) {
            fail(id, new RefusedException(String.valueOf(e.getMessage())));
        } catch (ConnectionException e) {
            fail(id, new LostException(String.valueOf(e.getMessage())));
        }
    }

    /** Asks for what is written into the scene when it comes; what is refused stays as it is. */
    void want(Message message) {
        var _ = ask(message);
    }

    /** How many questions wait for their answers. */
    int unanswered() {
        return open.size();
    }

    private void fail(String id, RefusedException why) {
        CompletableFuture<Message> answer = open.remove(id);
        if (answer != null) {
            answer.completeExceptionally(why);
        }
    }

    /**
     * Reads until the connection ends, and hands on what comes.
     *
     * @return why it ended, in a sentence
     */
    String read(Consumer<Letter> reader) {
        String why = "The simulator at %s has ended the connection.".formatted(client.address());
        try {
            Optional<String> text = client.nextText();
            while (text.isPresent()) {
                Letter letter = Letter.read(text.get(), catalogue);
                reader.accept(letter);
                why = farewell(letter).orElse(why);
                letter.requestId().ifPresent(id -> answer(id, letter));
                text = client.nextText();
            }
        } catch (ConnectionException e) {
            why = String.valueOf(e.getMessage());
        } catch (AuvsmlException e) {
            why =
                    "What the simulator at %s sent is not AUVSML: %s."
                            .formatted(client.address(), e.getMessage());
        }
        ended = true;
        for (String id : open.keySet()) {
            fail(id, new LostException(why));
        }
        return why;
    }

    private Optional<String> farewell(Letter letter) {
        return letter.messages().stream()
                .filter(DisconnectedNotification.class::isInstance)
                .map(DisconnectedNotification.class::cast)
                .map(m -> "The simulator at %s ends: %s.".formatted(client.address(), m.reason()))
                .findFirst();
    }

    private void answer(String id, Letter letter) {
        CompletableFuture<Message> answer = open.remove(id);
        if (answer == null) {
            return;
        }
        if (letter.messages().isEmpty()) {
            answer.completeExceptionally(new UnknownException(letter.unknownWords()));
        } else if (letter.messages().getFirst() instanceof ErrorResponse error) {
            answer.completeExceptionally(new RefusedException(error.text()));
        } else {
            answer.complete(letter.messages().getFirst());
        }
    }

    void close() {
        client.close();
        writer.shutdownNow();
    }
}
