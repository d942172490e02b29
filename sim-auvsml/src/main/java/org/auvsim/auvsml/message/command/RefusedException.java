package org.auvsim.auvsml.message.command;

import org.auvsim.auvsml.ErrorCode;

/**
 * A command that was understood but is not carried out; its sender gets an {@code error-response}.
 */
public final class RefusedException extends RuntimeException {
    private final ErrorCode code;

    /** With one clear sentence that says why, and what to do. */
    public RefusedException(ErrorCode code, String text) {
        super(text);
        this.code = code;
    }

    /** The kind of error. */
    public ErrorCode code() {
        return code;
    }
}
