package org.auvsim.cli;

/** A run that cannot go on; its sentence says where it ends, and why. */
final class RunEndedException extends RuntimeException {
    private static final long serialVersionUID = 1L;

    private final String sentence;

    /** With one sentence, and what led to it. */
    RunEndedException(String sentence, Throwable cause) {
        super(sentence, cause);
        this.sentence = sentence;
    }

    /** Where the run ends, and why. */
    String sentence() {
        return sentence;
    }
}
