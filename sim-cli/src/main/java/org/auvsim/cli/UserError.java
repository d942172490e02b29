package org.auvsim.cli;

/**
 * What the user asked for cannot be done; its message is the one sentence they see, and the
 * command's exit code is 2.
 */
final class UserError extends RuntimeException {
    private static final long serialVersionUID = 1L;

    UserError(String sentence) {
        super(sentence);
    }

    UserError(String sentence, Throwable cause) {
        super(sentence, cause);
    }
}
