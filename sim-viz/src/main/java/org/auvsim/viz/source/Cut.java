package org.auvsim.viz.source;

/**
 * Where a course goes on otherwise: what lies after it is forgotten.
 *
 * @param time (s)
 * @param order the number of the last entry that counts
 */
record Cut(double time, int order) {
    /** At a time, whatever told of it. */
    static Cut at(double time) {
        return new Cut(time, Integer.MAX_VALUE);
    }

    /** Whether something is forgotten that entry {@code itsOrder} told of a time (s). */
    boolean drops(double itsTime, int itsOrder) {
        return itsTime > time || itsOrder > order;
    }
}
