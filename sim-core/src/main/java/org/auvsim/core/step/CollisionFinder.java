package org.auvsim.core.step;

/** The third stage: finds the earliest collision (thesis, section 5.1.3). */
public interface CollisionFinder {
    /**
     * Offset (s, 0 to {@code dt}) of the earliest collision among the pairs that share a set;
     * infinity if there is none. At that offset the pair overlaps.
     */
    double earliest(Motion motion, CollisionSets sets, double dt);
}
