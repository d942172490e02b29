package org.auvsim.diagnosis.reading;

/**
 * That numbers may not be what they are taken for, unless a model explains them as they are.
 *
 * @param seen where, and what looks like it
 * @param question what they may be
 * @param answer to it, once a model explains the runs
 */
record Suspicion(String seen, String question, String answer) {
    /** Angles or rates that are large for radians, as those of a body that goes round and round. */
    static Suspicion ofTurns(String seen, String question) {
        return new Suspicion(
                seen, ": " + question, ", and the model explains them so: they are in radians");
    }

    /** What is suspected. */
    String notice() {
        return seen + question;
    }

    /** What is left to say once a model explains the runs. */
    String settled() {
        return seen + answer;
    }

    /** The same of a file. */
    Suspicion of(Object file) {
        return new Suspicion(file + ": " + seen, question, answer);
    }
}
