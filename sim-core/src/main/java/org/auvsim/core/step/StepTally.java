package org.auvsim.core.step;

/** Counts what steps do; it belongs to one world and only grows. */
public final class StepTally {
    long collisions;
    long events;
    long subSteps;
    long heldPairs;
    long quickHits;
    long crowdedHits;
    long loweredHits;
    long unsolvedIslands;

    /** What has been counted so far. */
    public StepStatistics statistics() {
        return new StepStatistics(
                collisions,
                events,
                subSteps,
                heldPairs,
                quickHits,
                crowdedHits,
                loweredHits,
                unsolvedIslands);
    }

    /** What has been counted since it was as {@code before}. */
    public StepStatistics since(StepTally before) {
        return new StepStatistics(
                collisions - before.collisions,
                events - before.events,
                subSteps - before.subSteps,
                heldPairs - before.heldPairs,
                quickHits - before.quickHits,
                crowdedHits - before.crowdedHits,
                loweredHits - before.loweredHits,
                unsolvedIslands - before.unsolvedIslands);
    }

    /** Takes the counts of another. */
    public void set(StepTally other) {
        collisions = other.collisions;
        events = other.events;
        subSteps = other.subSteps;
        heldPairs = other.heldPairs;
        quickHits = other.quickHits;
        crowdedHits = other.crowdedHits;
        loweredHits = other.loweredHits;
        unsolvedIslands = other.unsolvedIslands;
    }

    /** An independent copy. */
    public StepTally copy() {
        StepTally copy = new StepTally();
        copy.set(this);
        return copy;
    }
}
