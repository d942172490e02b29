// SPDX-License-Identifier: GPL-2.0-or-later
package org.auvsim.osp;

import org.auvsim.core.dynamics.EquationsOfMotion;
import org.auvsim.core.entity.Block;
import org.auvsim.core.entity.BodyState;
import org.opensourcephysics.numerics.ODE;

/**
 * Some bodies of a block as Open Source Physics sees a system: their states, one body after the
 * other, and time as the last entry. Other bodies of the block stay as they are.
 */
final class BlockOde implements ODE {
    private final EquationsOfMotion equations;
    private final Block block;
    private final int[] bodies;
    private final double[] state;

    /** The bodies at these places of the block, from its present state on. */
    BlockOde(EquationsOfMotion equations, Block block, int[] bodies) {
        this.equations = equations;
        this.block = block;
        this.bodies = bodies;
        this.state = new double[bodies.length * BodyState.COLUMNS + 1];
        read(block.state, state);
        state[state.length - 1] = block.time;
    }

    @Override
    public double[] getState() {
        return state;
    }

    @Override
    public void getRate(double[] at, double[] rate) {
        write(at);
        equations.evaluate(block);
        read(block.rate, rate);
        rate[rate.length - 1] = 1;
    }

    /** Makes the solver's state that of the block. */
    void finish() {
        write(state);
    }

    private void read(double[][] from, double[] to) {
        int k = 0;
        for (int body : bodies) {
            for (int c = 0; c < BodyState.COLUMNS; c++) {
                to[k++] = from[c][body];
            }
        }
    }

    /** A zero gets no sign. */
    private void write(double[] from) {
        int k = 0;
        for (int body : bodies) {
            for (int c = 0; c < BodyState.COLUMNS; c++) {
                block.state[c][body] = from[k++] + 0.0;
            }
        }
        block.time = from[k];
    }
}
