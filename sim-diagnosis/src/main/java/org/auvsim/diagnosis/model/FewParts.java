package org.auvsim.diagnosis.model;

import org.auvsim.core.dynamics.EquationsOfMotion;
import org.auvsim.core.dynamics.Integrator;
import org.auvsim.core.dynamics.Rk4;
import org.auvsim.core.entity.Block;
import org.auvsim.core.step.StepException;

/**
 * Runge and Kutta's method that refuses steps which the engine cuts into many parts, before it has
 * made them all: where a motion explodes in steps that are too long, nothing else takes longer.
 */
final class FewParts implements Integrator {
    private static final int MOST = 64;

    private final Rk4 method = new Rk4();
    private double shortest;

    /** A step of so many seconds follows. */
    void of(double step) {
        shortest = step / MOST * (1 - 1e-9);
    }

    /**
     * As of {@link Integrator}.
     *
     * @throws StepException if it is a smaller part of the step
     */
    @Override
    public void advance(EquationsOfMotion equations, Block block, double dt) {
        if (dt < shortest) {
            throw new StepException("a step is cut into more than %d parts".formatted(MOST));
        }
        method.advance(equations, block, dt);
    }
}
