package org.auvsim.core.dynamics;

import org.auvsim.core.entity.Block;

/** A step of one body, cut into equal parts because its forces are stiff. */
public final class SubSteps {
    /**
     * Parts whose z ({@link Stiffness}) is up to this are fine: damped, though not to a percent.
     */
    private static final int FINE = 2;

    /** Loads one body into a block, as it is at the step's begin, with all that acts on it. */
    public interface Load {
        /** Fills the block. */
        void into(Block block);
    }

    private SubSteps() {}

    /**
     * Integrates a body in as many parts as needed, twice as many each time; the end is in the
     * block.
     *
     * @param parts with which to begin
     * @return how many parts were needed; 0 if the most that are made ({@link
     *     Block#MOST_SUB_STEPS}) are too few
     */
    public static int integrate(
            Integrator integrator,
            EquationsOfMotion equations,
            Block block,
            Load load,
            double dt,
            int parts) {
        for (int n = parts; n <= Block.MOST_SUB_STEPS; n *= 2) {
            load.into(block);
            if (isFine(integrator, equations, block, dt, n)) {
                return n;
            }
        }
        return 0;
    }

    private static boolean isFine(
            Integrator integrator, EquationsOfMotion equations, Block block, double dt, int parts) {
        double begin = block.time;
        for (int k = 0; k < parts; k++) {
            block.time = begin + k * (dt / parts);
            equations.evaluate(block);
            integrator.advance(equations, block, dt / parts);
            for (int i = 0; i < block.count; i++) {
                if (block.subSteps(i) > FINE) {
                    return false;
                }
            }
        }
        block.time = begin + dt;
        return true;
    }
}
