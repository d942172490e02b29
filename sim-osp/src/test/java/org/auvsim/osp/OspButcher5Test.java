// SPDX-License-Identifier: GPL-2.0-or-later
package org.auvsim.osp;

import org.auvsim.core.dynamics.Integrator;
import org.auvsim.core.dynamics.IntegratorContract;

class OspButcher5Test extends IntegratorContract {
    @Override
    protected Integrator integrator() {
        return new OspButcher5();
    }

    @Override
    protected int order() {
        return 5;
    }
}
