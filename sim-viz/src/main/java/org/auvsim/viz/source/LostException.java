package org.auvsim.viz.source;

/** Nobody knows what the simulator would have answered: there is no connection to it any more. */
public final class LostException extends RefusedException {
    private static final long serialVersionUID = 1L;

    /** With a sentence for people. */
    public LostException(String sentence) {
        super(sentence);
    }
}
