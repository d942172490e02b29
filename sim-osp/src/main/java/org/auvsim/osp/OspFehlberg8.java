// SPDX-License-Identifier: GPL-2.0-or-later
package org.auvsim.osp;

import org.opensourcephysics.numerics.Fehlberg8;
import org.opensourcephysics.numerics.ODE;
import org.opensourcephysics.numerics.ODESolver;

/** Fehlberg's Runge-Kutta method of order 8, with thirteen stages. */
public record OspFehlberg8() implements FixedStep {
    @Override
    public ODESolver solver(ODE ode) {
        return new Fehlberg8(ode);
    }
}
