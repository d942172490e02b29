package org.auvsim.cli.admin;

import org.auvsim.auvsml.client.AuvsmlClient;
import org.auvsim.auvsml.client.ConnectionException;
import org.auvsim.auvsml.client.Received;
import org.auvsim.auvsml.message.Message;
import org.auvsim.auvsml.message.session.DisconnectedNotification;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.locks.Condition;
import java.util.concurrent.locks.ReentrantLock;
import java.util.function.Consumer;

/**
 * Questions and answers over one connection. A thread of its own takes what comes: answers to the
 * one who asked and still waits, all else as notices. One thread asks.
 */
final class Conversation {
    private final AuvsmlClient client;
    private final ReentrantLock lock = new ReentrantLock();
    private final Condition changed = lock.newCondition();
    private final List<Message> answers = new ArrayList<>();
    private Optional<String> awaited = Optional.empty();
    private int asked;
    private boolean ended;
    private Optional<DisconnectedNotification> farewell = Optional.empty();

    /** A conversation that has yet to begin. */
    Conversation(AuvsmlClient client) {
        this.client = client;
    }

    /**
     * Takes what comes from now on, on a thread of its own.
     *
     * @param notices gets what nobody has asked for, but not the farewell
     * @param afterwards is done when the connection has ended
     */
    void begin(Consumer<Message> notices, Runnable afterwards) {
        Thread.ofVirtual()
                .name("listen")
                .start(
                        () -> {
                            listen(notices);
                            end();
                            afterwards.run();
                        });
    }

    private void listen(Consumer<Message> notices) {
        try {
            Optional<Received> received = client.next();
            while (received.isPresent()) {
                if (!isAnswer(received.get())) {
                    received.get().messages().forEach(message -> tell(message, notices));
                }
                received = client.next();
            }
        } catch (ConnectionException _) {
            // whoever asks next is told
        }
    }

    private void tell(Message message, Consumer<Message> notices) {
        if (message instanceof DisconnectedNotification disconnected) {
            lock.lock();
            try {
                farewell = Optional.of(disconnected);
            } finally {
                lock.unlock();
            }
        } else {
            notices.accept(message);
        }
    }

    private boolean isAnswer(Received received) {
        lock.lock();
        try {
            boolean isAnswer = awaited.isPresent() && received.requestId().equals(awaited);
            if (isAnswer) {
                answers.addAll(received.messages());
                changed.signalAll();
            }
            return isAnswer;
        } finally {
            lock.unlock();
        }
    }

    private void end() {
        lock.lock();
        try {
            ended = true;
            changed.signalAll();
        } finally {
            lock.unlock();
        }
    }

    /**
     * Why the simulator has ended the connection, if it has said so: the last that is to be told.
     */
    Optional<DisconnectedNotification> farewell() {
        lock.lock();
        try {
            return farewell;
        } finally {
            lock.unlock();
        }
    }

    /** Whether the connection has ended. */
    boolean hasEnded() {
        lock.lock();
        try {
            return ended;
        } finally {
            lock.unlock();
        }
    }

    /**
     * Sends messages and waits for the answer to each of them.
     *
     * @param patience for so long; what comes later is a notice
     * @return the answers; fewer than messages if they are late or the connection has ended
     * @throws ConnectionException if the simulator has gone
     */
    List<Message> ask(List<Message> messages, Duration patience)
            throws ConnectionException, InterruptedException {
        String id = "admin-" + ++asked;
        await(Optional.of(id));
        try {
            client.request(id, messages.toArray(Message[]::new));
            return await(messages.size(), patience.toNanos());
        } finally {
            await(Optional.empty());
        }
    }

    private void await(Optional<String> id) {
        lock.lock();
        try {
            answers.clear();
            awaited = id;
        } finally {
            lock.unlock();
        }
    }

    private List<Message> await(int count, long nanos) throws InterruptedException {
        lock.lock();
        try {
            long left = nanos;
            while (answers.size() < count && !ended && left > 0) {
                left = changed.awaitNanos(left);
            }
            return List.copyOf(answers);
        } finally {
            lock.unlock();
        }
    }
}
