package org.auvsim.viz.source;

/** An answer that cannot be read, as it needs what this viewer does not know. */
final class UnknownException extends RefusedException {
    private static final long serialVersionUID = 1L;

    private final String words;

    UnknownException(String words) {
        super(
                "The answer holds %s, which this viewer does not know: start it with the simulator's --extensions."
                        .formatted(words));
        this.words = words;
    }

    /** The elements that are unknown, for people. */
    String words() {
        return words;
    }
}
