package org.auvsim.diagnosis.reading;

/**
 * Angles or rates that are large for radians, as those of a body that goes round and round are.
 *
 * @param seen where, and how large
 * @param question what they may be
 */
record ManyTurns(String seen, String question) {
    /** What is suspected. */
    String notice() {
        return seen + ": " + question;
    }

    /** What is left to say once a model explains the runs. */
    String settled() {
        return seen + ", and the model explains them so: they are in radians";
    }
}
