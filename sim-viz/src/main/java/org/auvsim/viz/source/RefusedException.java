package org.auvsim.viz.source;

/** The simulator did not do what it was asked for; its message is a sentence for people. */
public sealed class RefusedException extends Exception permits LostException, UnknownException {
    private static final long serialVersionUID = 1L;

    RefusedException(String sentence) {
        super(sentence);
    }
}
