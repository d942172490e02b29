// SPDX-License-Identifier: GPL-2.0-or-later
package org.auvsim.osp;

import org.auvsim.core.dynamics.EquationsOfMotion;
import org.auvsim.core.dynamics.Integrator;
import org.auvsim.core.entity.Block;
import org.opensourcephysics.numerics.ODE;
import org.opensourcephysics.numerics.ODESolver;

import java.util.stream.IntStream;

/** An integrator whose solver goes over a step at once, with all bodies of a block together. */
interface FixedStep extends Integrator {
    /** A new solver, as it has arrays of the size of what it solves. */
    ODESolver solver(ODE ode);

    @Override
    default void advance(EquationsOfMotion equations, Block block, double dt) {
        double begin = block.time;
        BlockOde ode = new BlockOde(equations, block, IntStream.range(0, block.count).toArray());
        ODESolver solver = solver(ode);
        solver.initialize(dt);
        solver.step();
        ode.finish();
        block.time = begin + dt;
        equations.normalizeOrientations(block);
    }
}
