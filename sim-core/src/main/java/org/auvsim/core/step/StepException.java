package org.auvsim.core.step;

/** A step that cannot be made; its message names the object and the time, and says what to do. */
public final class StepException extends RuntimeException {
    private static final long serialVersionUID = 1;

    /** With one clear sentence. */
    public StepException(String message) {
        super(message);
    }

    /** With one clear sentence and what has led to it. */
    public StepException(String message, Throwable cause) {
        super(message, cause);
    }
}
