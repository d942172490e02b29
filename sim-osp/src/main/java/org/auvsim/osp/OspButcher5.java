// SPDX-License-Identifier: GPL-2.0-or-later
package org.auvsim.osp;

import org.opensourcephysics.numerics.Butcher5;
import org.opensourcephysics.numerics.ODE;
import org.opensourcephysics.numerics.ODESolver;

/** Butcher's Runge-Kutta method of order 5, with six stages. */
public record OspButcher5() implements FixedStep {
    @Override
    public ODESolver solver(ODE ode) {
        return new Butcher5(ode);
    }
}
