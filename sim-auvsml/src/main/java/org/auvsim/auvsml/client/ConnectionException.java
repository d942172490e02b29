package org.auvsim.auvsml.client;

import java.io.IOException;

/**
 * There is no connection to a simulator, or no longer; its message is one sentence for people that
 * names the address.
 */
public final class ConnectionException extends IOException {
    private static final long serialVersionUID = 1L;

    ConnectionException(String sentence) {
        super(sentence);
    }

    ConnectionException(String sentence, Throwable cause) {
        super(sentence, cause);
    }
}
