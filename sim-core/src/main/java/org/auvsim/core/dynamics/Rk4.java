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
        for (int stage = 0; stage < NODE.length; stage++) {
            if (stage > 0) {
                block.time = begin + NODE[stage] * dt;
                addScaled(block.state, start, NODE[stage] * dt, block.rate, block.count);
            }
            equations.evaluate(block);
            addScaled(sum, sum, WEIGHT[stage] * dt, block.rate, block.count);
        }
        for (int c = 0; c < BodyState.COLUMNS; c++) {
            System.arraycopy(sum[c], 0, block.state[c], 0, block.count);
        }
        block.time = begin + dt;
        equations.normalizeOrientations(block);
    }

    /** to = base + factor * rate, column by column. */
    private static void addScaled(
            double[][] to, double[][] base, double factor, double[][] rate, int count) {
        for (int c = 0; c < BodyState.COLUMNS; c++) {
            addScaled(to[c], base[c], factor, rate[c], count);
        }
    }

    private static void addScaled(
            double[] to, double[] base, double factor, double[] rate, int count) {
        for (int i = 0; i < count; i++) {
            to[i] = base[i] + factor * rate[i];
        }
    }
}
