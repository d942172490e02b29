package org.auvsim.core.step;

/** Moves the bodies of a world on by one step, collisions included. */
public interface Stepper {
    /**
     * Moves time on by at most {@code wanted} (s) and responds to the collisions met.
     *
     * @throws StepException if no step can be made
     */
    StepResult advance(Motion motion, double wanted);
}
