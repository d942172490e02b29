// SPDX-License-Identifier: GPL-2.0-or-later
package org.auvsim.osp;

import org.auvsim.core.dynamics.Integrator;
import org.auvsim.core.dynamics.IntegratorContract;

/** With a tolerance that never cuts a step, which shows the order of the method. */
class OspRk45MultiStepTest extends IntegratorContract {
    @Override
    protected Integrator integrator() {
        return new OspRk45MultiStep(0.5);
    }

    @Override
    protected int order() {
        return 5;
    }
}
