package org.auvsim.auvsml.framing;

import org.auvsim.auvsml.Fault;
import org.auvsim.auvsml.message.Message;

import java.util.List;
import java.util.Optional;

/** What came in next. */
public sealed interface Incoming {
    /**
     * A root element with its messages: at least one, but for a lenient reader that knows none of
     * them.
     *
     * @param requestId the root's {@code request-id}, which goes back with responses and errors
     */
    record Request(Optional<String> requestId, List<Message> messages) implements Incoming {
        /** The messages cannot be changed. */
        public Request {
            messages = List.copyOf(messages);
        }
    }

    /**
     * A root element or other text that cannot be read; nothing of it counts, the next one does.
     *
     * @param requestId the root's {@code request-id}, if it could be read
     * @param fault what is wrong, its place counted from the start of the stream
     */
    record Rejected(Optional<String> requestId, Fault fault) implements Incoming {}

    /** The other side has ended the stream. */
    record End() implements Incoming {}
}
