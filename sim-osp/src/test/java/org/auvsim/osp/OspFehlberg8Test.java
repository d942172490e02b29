// SPDX-License-Identifier: GPL-2.0-or-later
package org.auvsim.osp;

import org.auvsim.core.dynamics.Integrator;
import org.auvsim.core.dynamics.IntegratorContract;

class OspFehlberg8Test extends IntegratorContract {
    @Override
    protected Integrator integrator() {
        return new OspFehlberg8();
    }

    @Override
    protected int order() {
        return 8;
    }

    /**
     * More steps leave nothing of its error but rounding, and so few do not show the order well.
     */
    @Override
    protected int coarseSteps() {
        return 12;
    }

    @Override
    protected double orderWithin() {
        return 0.4;
    }
}
