// SPDX-License-Identifier: GPL-2.0-or-later
package org.auvsim.osp;

import org.auvsim.core.description.Default;
import org.opensourcephysics.numerics.ODE;
import org.opensourcephysics.numerics.ODEAdaptiveSolver;
import org.opensourcephysics.numerics.RK45MultiStep;

/**
 * The method of Dormand and Prince, of order 5 with an estimate of order 4, in as many parts of a
 * step as its tolerance needs.
 *
 * @param tolerance the most that the estimate of a part's error may be, in the state's numbers
 */
public record OspRk45MultiStep(@Default("1e-9") double tolerance) implements AdaptiveStep {
    /**
     * A checked method.
     *
     * @throws IllegalArgumentException if the tolerance is not 1e-12 to 0.5
     */
    public OspRk45MultiStep {
        Tolerance.require("an RK45 multi-step", tolerance);
    }

    @Override
    public ODEAdaptiveSolver solver(ODE ode, double dt) {
        RK45MultiStep solver = new RK45MultiStep(ode);
        solver.setTolerance(tolerance);
        solver.initialize(dt);
        solver.setStepSize(dt);
        return solver;
    }
}
