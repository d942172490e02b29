package org.auvsim.diagnosis.search;

import java.util.Optional;

/**
 * How causes are searched for.
 *
 * @param contest by which models are found; empty: by what causes leave in the data
 * @param isThorough whether more than two causes at once are looked for where no fewer explain the
 *     runs, and each from all places where it may begin
 */
public record Way(Optional<Arena.Contest> contest, boolean isThorough) {
    /** By what causes leave in the data, until one explains it or all was tried. */
    public static final Way THOROUGH = new Way(Optional.empty(), true);

    /** By a contest of models. */
    public static Way by(Arena.Contest contest) {
        return new Way(Optional.of(contest), true);
    }

    /** The same of data that may not be what they are taken for: more causes would imitate that. */
    public Way cursory() {
        return new Way(contest, false);
    }
}
