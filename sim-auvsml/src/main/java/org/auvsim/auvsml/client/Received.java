package org.auvsim.auvsml.client;

import org.auvsim.auvsml.message.Message;

import java.util.List;
import java.util.Optional;

/**
 * One root element from the simulator.
 *
 * @param requestId that of the request which it answers
 * @param messages those that this side knows, in order; others are left out
 */
public record Received(Optional<String> requestId, List<Message> messages) {
    /** The messages cannot be changed. */
    public Received {
        messages = List.copyOf(messages);
    }
}
