package org.auvsim.core.step;

/**
 * Looks for overlap at the end of the step alone (thesis, section 5.1.4): cheap, lets bodies
 * overlap and quick ones pass through each other.
 */
public record EndOfStepFinder() implements CollisionFinder {
    @Override
    public double earliest(Motion motion, CollisionSets sets, double dt) {
        for (int k = 0; k < sets.pairCount(); k++) {
            int i = sets.first(k);
            int j = sets.second(k);
            if (motion.overlap(i, j, dt) && motion.approaching(i, j, dt)) {
                return dt;
            }
        }
        return Double.POSITIVE_INFINITY;
    }
}
