package org.auvsim.core.step;

/**
 * The first stage of a step: shortens it so that collisions are not jumped over (thesis, 5.1.1).
 */
public interface TimeStepRestricter {
    /**
     * The time step (s) to take, above 0 and at most {@code wanted}.
     *
     * @throws StepException if no step can be found
     */
    double restrict(Motion motion, double wanted);
}
