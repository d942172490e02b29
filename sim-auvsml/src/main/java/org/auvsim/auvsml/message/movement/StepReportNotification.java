package org.auvsim.auvsml.message.movement;

import org.auvsim.auvsml.message.Message;
import org.auvsim.core.description.Unit;

/**
 * How the step that ends at this time was kept from getting stuck or diverging; a step that needed
 * nothing of it is not reported.
 *
 * @param subSteps parts that were added because forces are stiff, or contact forces would add
 *     energy
 * @param heldPairs pairs that rested on each other and were held together
 * @param quickHits collisions without loss, as the pair had met within the last 10 ms
 * @param crowdedHits collisions without restitution, as too much happened to a heap in one step to
 *     follow it all
 * @param loweredHits collisions whose restitution was lowered, as at all their contacts together,
 *     or with friction, it would have added energy
 * @param unsolvedIslands times that the forces between bodies in contact were not found as well as
 *     asked for within the rounds allowed: the bodies may slip a little more
 */
public record StepReportNotification(
        @Unit("s") double timestamp,
        long subSteps,
        long heldPairs,
        long quickHits,
        long crowdedHits,
        long loweredHits,
        long unsolvedIslands)
        implements Message {}
