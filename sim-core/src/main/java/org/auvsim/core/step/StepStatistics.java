package org.auvsim.core.step;

/**
 * What the steps of a world have done since it was built.
 *
 * @param collisions pairs that have met and responded
 * @param events instants within frames at which something was moved: collisions, ends of sub-steps
 * @param subSteps segments that were added because forces are stiff, or contact forces would add
 *     energy
 * @param heldPairs pairs that were held together for the rest of a frame, counted once a frame
 * @param quickHits collisions without loss, as the pair had met within the last 10 ms
 * @param crowdedHits collisions without restitution, as too much happened to a heap in one frame to
 *     follow it all
 * @param loweredHits collisions whose restitution was lowered, as at all their contacts together,
 *     or with friction, it would have added energy
 * @param unsolvedIslands times that the forces or impulses between bodies in contact were not found
 *     as well as asked for within the rounds allowed: the bodies may slip a little more
 */
public record StepStatistics(
        long collisions,
        long events,
        long subSteps,
        long heldPairs,
        long quickHits,
        long crowdedHits,
        long loweredHits,
        long unsolvedIslands) {}
