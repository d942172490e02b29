package org.auvsim.core.step;

/** Counts what steps do; it belongs to one world and only grows. */
public final class StepTally {
    long collisions;
    long events;
    long subSteps;
    long heldPairs;
    long quickHits;

    /** What has been counted so far. */
    public StepStatistics statistics() {
        return new StepStatistics(collisions, events, subSteps, heldPairs, quickHits);
    }

    /** An independent copy. */
    public StepTally copy() {
        StepTally copy = new StepTally();
        copy.collisions = collisions;
        copy.events = events;
        copy.subSteps = subSteps;
        copy.heldPairs = heldPairs;
        copy.quickHits = quickHits;
        return copy;
    }
}
