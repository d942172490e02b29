package org.auvsim.auvsml.client;

/**
 * What was to be sent in one root element is longer than a simulator takes; nothing was sent, and
 * the connection goes on. Its message is one sentence for people.
 */
public final class TooLongException extends IllegalArgumentException {
    private static final long serialVersionUID = 1L;

    TooLongException(int bytes, int most) {
        super("a simulator takes at most %d bytes at once, but this has %d".formatted(most, bytes));
    }
}
