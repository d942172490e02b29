package org.auvsim.viz.drawing;

/** Nothing can be shown here; its message is one sentence for people. */
public final class ScreenException extends Exception {
    private static final long serialVersionUID = 1L;

    /** Says what is missing and what to do. */
    public ScreenException(String sentence, Throwable cause) {
        super(sentence, cause);
    }

    /** Says what is missing and what to do. */
    public ScreenException(String sentence) {
        super(sentence);
    }
}
