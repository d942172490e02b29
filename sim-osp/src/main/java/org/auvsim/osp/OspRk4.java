// SPDX-License-Identifier: GPL-2.0-or-later
package org.auvsim.osp;

import org.opensourcephysics.numerics.ODE;
import org.opensourcephysics.numerics.ODESolver;
import org.opensourcephysics.numerics.RK4;

/** The classical Runge-Kutta method of order 4. */
public record OspRk4() implements FixedStep {
    @Override
    public ODESolver solver(ODE ode) {
        return new RK4(ode);
    }
}
