package org.auvsim.core.step;

import org.auvsim.core.entity.Change;

import java.util.List;

/**
 * What a step did.
 *
 * @param elapsed how far time has moved (s)
 * @param collisions in order of time, those of one instant in order of the ids of the two
 * @param changes what responses want changed beside momenta, which have been changed already
 * @param isInterrupted whether the same step is to go on for the rest of its length, once the
 *     changes have been made
 */
public record StepResult(
        double elapsed, List<Collision> collisions, List<Change> changes, boolean isInterrupted) {
    static StepResult of(double elapsed, List<Collision> collisions) {
        return new StepResult(elapsed, List.copyOf(collisions), List.of(), false);
    }
}
