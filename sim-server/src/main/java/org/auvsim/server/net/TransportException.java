package org.auvsim.server.net;

/** A transport that cannot be opened; one clear sentence that says what to do. */
public final class TransportException extends RuntimeException {
    private static final long serialVersionUID = 1;

    /** With one clear sentence, and what lies behind it. */
    public TransportException(String message, Throwable cause) {
        super(message, cause);
    }
}
