// SPDX-License-Identifier: GPL-2.0-or-later
package org.auvsim.osp;

import org.auvsim.core.dynamics.BodyGroups;
import org.auvsim.core.dynamics.EquationsOfMotion;
import org.auvsim.core.dynamics.Integrator;
import org.auvsim.core.entity.Block;
import org.opensourcephysics.numerics.ODE;
import org.opensourcephysics.numerics.ODEAdaptiveSolver;

import java.util.Arrays;

/**
 * An integrator whose solver cuts a step until its own estimate of the error is below a tolerance.
 * Bodies that nothing couples are solved each by itself: how one is cut depends on no other, nor on
 * which block it is in.
 */
interface AdaptiveStep extends Integrator {
    /**
     * The most that the estimate may be in any number of the state: m, kg m/s, kg m^2/s, or a part
     * of a quaternion.
     */
    double tolerance();

    /** A new solver whose step goes over all of {@code dt}. */
    ODEAdaptiveSolver solver(ODE ode, double dt);

    @Override
    default void advance(EquationsOfMotion equations, Block block, double dt) {
        double begin = block.time;
        double[][] start = block.work(2)[0];
        double[][] end = block.work(2)[1];
        copy(block, block.state, start);
        boolean[] done = new boolean[block.count];
        for (int i = 0; i < block.count; i++) {
            if (!done[i]) {
                int[] bodies = together(equations.groups(), block, i);
                copy(block, start, block.state);
                block.time = begin;
                solve(new BlockOde(equations, block, bodies), block, bodies, dt);
                for (int body : bodies) {
                    done[body] = true;
                    for (int c = 0; c < end.length; c++) {
                        end[c][body] = block.state[c][body];
                    }
                }
            }
        }
        copy(block, end, block.state);
        block.time = begin + dt;
        equations.normalizeOrientations(block);
    }

    private void solve(BlockOde ode, Block block, int[] bodies, double dt) {
        ODEAdaptiveSolver solver = solver(ode, dt);
        solver.step();
        ode.finish();
        if (solver.getErrorCode() != ODEAdaptiveSolver.NO_ERROR) {
            // The world makes the step again in shorter parts.
            Arrays.stream(bodies).forEach(body -> block.setSubSteps(body, 2));
        }
    }

    private static int[] together(BodyGroups groups, Block block, int i) {
        if (!groups.isCoupled(block.slot(i))) {
            return new int[] {i};
        }
        return Arrays.stream(groups.members(block.slot(i)))
                .map(block::indexOf)
                .filter(at -> at >= 0)
                .toArray();
    }

    private static void copy(Block block, double[][] from, double[][] to) {
        for (int c = 0; c < from.length; c++) {
            System.arraycopy(from[c], 0, to[c], 0, block.count);
        }
    }
}
