package org.auvsim.cli;

/** A run that cannot go on; its message says where it ends, and why. */
final class RunEndedException extends RuntimeException {
    private static final long serialVersionUID = 1L;

    /** With one sentence, and what led to it. */
    RunEndedException(String sentence, Throwable cause) {
        super(sentence, cause);
    }
}
