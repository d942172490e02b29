package org.auvsim.core.dynamics;

import org.auvsim.core.entity.Block;

/**
 * A method that solves the equations of motion over one step; stateless, so that worlds share it.
 */
public interface Integrator {
    /**
     * Moves the state of a block, and its time, on by {@code dt} (s); orientations are of length 1
     * afterwards.
     *
     * @param block evaluated by the equations as it is: rates and velocities at the start are there
     */
    void advance(EquationsOfMotion equations, Block block, double dt);
}
