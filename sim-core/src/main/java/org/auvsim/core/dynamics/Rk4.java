package org.auvsim.core.dynamics;

import org.auvsim.core.entity.Block;
import org.auvsim.core.entity.BodyState;

/**
 * The classical Runge-Kutta method of order 4 (thesis, section 5.2; Hairer, Norsett &amp; Wanner,
 * Solving Ordinary Differential Equations I, 1993, II.1).
 */
public record Rk4() implements Integrator {
    /**
     * Each stage starts from the step's beginning and goes this share of the step along the last.
     */
    private static final double[] NODE = {0, 0.5, 0.5, 1};

    private static final double[] WEIGHT = {1.0 / 6, 1.0 / 3, 1.0 / 3, 1.0 / 6};

    @Override
    public void advance(EquationsOfMotion equations, Block block, double dt) {
        double[][][] work = block.work(2);
        double[][] start = work[0];
        double[][] sum = work[1];
        double begin = block.time;
        for (int c = 0; c < BodyState.COLUMNS; c++) {
            System.arraycopy(block.state[c], 0, start[c], 0, block.count);
            System.arraycopy(block.state[c], 0, sum[c], 0, block.count);
        }
        for (int stage = 0; stage < 3; stage++) {
            equations.evaluate(block);
            double next = NODE[stage + 1] * dt;
            for (int c = 0; c < BodyState.COLUMNS; c++) {
                addScaled(sum[c], sum[c], WEIGHT[stage] * dt, block.rate[c], block.count);
                addScaled(block.state[c], start[c], next, block.rate[c], block.count);
            }
            block.time = begin + next;
        }
        equations.evaluate(block);
        for (int c = 0; c < BodyState.COLUMNS; c++) {
            addScaled(block.state[c], sum[c], WEIGHT[3] * dt, block.rate[c], block.count);
        }
        block.time = begin + dt;
        equations.normalizeOrientations(block);
    }

    /** to = base + factor * rate. */
    private static void addScaled(
            double[] to, double[] base, double factor, double[] rate, int count) {
        for (int i = 0; i < count; i++) {
            to[i] = base[i] + factor * rate[i];
        }
    }
}
