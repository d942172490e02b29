package org.auvsim.cli.feed;

/** A log that cannot be used; its message is one sentence with the place, for people. */
public final class LogException extends Exception {
    private static final long serialVersionUID = 1L;

    LogException(String sentence) {
        super(sentence);
    }

    LogException(String sentence, Throwable cause) {
        super(sentence, cause);
    }
}
