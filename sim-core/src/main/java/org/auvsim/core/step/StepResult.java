package org.auvsim.core.step;

import org.auvsim.core.entity.Change;

import java.util.List;

/**
 * What a step did.
 *
 * @param elapsed how far time has moved (s)
 * @param collisions in order of the ids of the two
 * @param changes what responses want changed beside momenta, which have been changed already
 */
public record StepResult(double elapsed, List<Collision> collisions, List<Change> changes) {
    static StepResult of(double elapsed, List<Collision> collisions) {
        return new StepResult(elapsed, List.copyOf(collisions), List.of());
    }

    static StepResult withoutCollision(double elapsed) {
        return new StepResult(elapsed, List.of(), List.of());
    }
}
