package org.auvsim.junit;

/** A replay that cannot be made; its message is one sentence for the one who wrote the test. */
final class ReplayException extends Exception {
    private static final long serialVersionUID = 1L;

    ReplayException(String sentence) {
        super(sentence);
    }

    ReplayException(String sentence, Throwable cause) {
        super(sentence, cause);
    }
}
