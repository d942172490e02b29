package org.auvsim.viz.window;

import org.auvsim.auvsml.message.Message;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Consumer;

/**
 * Keeps what is to be sent until the next turn: of a slider that moves on meanwhile, only its last
 * place is sent.
 */
final class Outbox {
    private final Map<Object, Message> waiting = new LinkedHashMap<>();
    private final Consumer<Message> sender;

    Outbox(Consumer<Message> sender) {
        this.sender = sender;
    }

    /** Sends a message with the next turn, in place of a waiting one of the same key. */
    void put(Object key, Message message) {
        waiting.put(key, message);
    }

    /** Sends what waits. */
    void send() {
        List<Message> now = List.copyOf(waiting.values());
        waiting.clear();
        now.forEach(sender);
    }
}
