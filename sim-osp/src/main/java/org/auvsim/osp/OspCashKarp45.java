// SPDX-License-Identifier: GPL-2.0-or-later
package org.auvsim.osp;

import org.auvsim.core.description.Default;
import org.opensourcephysics.numerics.CashKarp45;
import org.opensourcephysics.numerics.ODE;
import org.opensourcephysics.numerics.ODEAdaptiveSolver;
import org.opensourcephysics.numerics.ODEMultistepSolver;

/**
 * The method of Cash and Karp, of order 5 with an estimate of order 4, in as many parts of a step
 * as its tolerance needs.
 *
 * @param tolerance the most that the estimate of a part's error may be, in the state's numbers
 */
public record OspCashKarp45(@Default("1e-9") double tolerance) implements AdaptiveStep {
    /**
     * A checked method.
     *
     * @throws IllegalArgumentException if the tolerance is not 1e-12 to 0.5
     */
    public OspCashKarp45 {
        Tolerance.require("a Cash-Karp method", tolerance);
    }

    @Override
    public ODEAdaptiveSolver solver(ODE ode, double dt) {
        ODEAdaptiveSolver solver = new Parts(ode);
        solver.setTolerance(tolerance);
        solver.initialize(dt);
        solver.setStepSize(dt);
        return solver;
    }

    private static final class Parts extends ODEMultistepSolver {
        Parts(ODE ode) {
            odeEngine = new CashKarp45(setODE(ode));
        }
    }
}
