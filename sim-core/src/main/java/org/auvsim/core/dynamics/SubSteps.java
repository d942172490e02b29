package org.auvsim.core.dynamics;

import org.auvsim.core.entity.Block;

import java.util.Arrays;

/** A step of bodies that is cut into equal parts because their forces are stiff. */
public final class SubSteps {
    /**
     * Parts whose z ({@link Stiffness}) is up to this are fine: damped, though not to a percent.
     */
    private static final int FINE = 2;

    private SubSteps() {}

    /**
     * Integrates the bodies of a block, as they are at the step's begin, in so many parts; the end
     * is in the block.
     *
     * @param fine told of each body: whether the parts are short enough for it
     */
    public static void integrate(
            Integrator integrator,
            EquationsOfMotion equations,
            Block block,
            double dt,
            int parts,
            boolean[] fine) {
        double begin = block.time;
        Arrays.fill(fine, 0, block.count, true);
        for (int k = 0; k < parts; k++) {
            block.time = begin + k * (dt / parts);
            equations.evaluate(block);
            integrator.advance(equations, block, dt / parts);
            for (int i = 0; i < block.count; i++) {
                fine[i] &= block.subSteps(i) <= FINE;
            }
        }
        block.time = begin + dt;
    }
}
