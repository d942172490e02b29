package org.auvsim.auvsml.recording;

import org.auvsim.core.description.Default;

/**
 * What a recording begins with; its scenario follows.
 *
 * @param version of the format
 * @param server the name and version of what recorded
 * @param hashEvery a {@link StateHash} stands after so many steps each
 */
public record Recording(int version, String server, @Default("20") int hashEvery) {
    /** The version of the format that is written, and the only one that is read. */
    public static final int VERSION = 1;

    /** So many steps lie between two hashes if nobody wants it otherwise. */
    public static final int USUAL_HASH_EVERY = 20;

    /**
     * A checked beginning.
     *
     * @throws IllegalArgumentException if hashes are not at least a step apart
     */
    public Recording {
        if (hashEvery < 1) {
            throw new IllegalArgumentException(
                    "hash-every must be 1 step or more, but is " + hashEvery);
        }
    }
}
