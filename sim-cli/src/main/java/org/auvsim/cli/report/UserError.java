package org.auvsim.cli.report;

/**
 * What the user asked for cannot be done; its message is the one sentence they see, and the
 * command's exit code is 2.
 */
public final class UserError extends RuntimeException {
    private static final long serialVersionUID = 1L;

    /** With that sentence. */
    public UserError(String sentence) {
        super(sentence);
    }

    /** With that sentence, and what led to it. */
    public UserError(String sentence, Throwable cause) {
        super(sentence, cause);
    }
}
