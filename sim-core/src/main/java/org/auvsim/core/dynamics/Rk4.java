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

    private static final int LAST = NODE.length - 1;
    private static final double[] WEIGHT = {1.0 / 6, 1.0 / 3, 1.0 / 3, 1.0 / 6};

    @Override
    public void advance(EquationsOfMotion equations, Block block, double dt) {
        double[][][] work = block.work(2);
        double[][] start = work[0];
        double[][] sum = work[1];
        double begin = block.time;
        block.time = begin + NODE[1] * dt;
        begin(block, start, NODE[1] * dt, sum, WEIGHT[0] * dt);
        for (int stage = 1; stage < LAST; stage++) {
            equations.evaluate(block);
            if (stage == 2 && equations.mayBeStiff()) {
                Stiffness.estimate(block, start, sum, dt);
            }
            block.time = begin + NODE[stage + 1] * dt;
            goOn(block, start, NODE[stage + 1] * dt, sum, WEIGHT[stage] * dt);
        }
        equations.evaluate(block);
        finish(block, sum, WEIGHT[LAST] * dt);
        block.time = begin + dt;
        equations.normalizeOrientations(block);
    }

    /** The first stage: keeps the start and begins the sum. */
    private static void begin(
            Block block, double[][] start, double step, double[][] sum, double weight) {
        boolean turns = block.turns();
        for (int c = 0; c < BodyState.COLUMNS; c++) {
            if (turns || !BodyState.isRotational(c)) {
                double[] state = block.state[c];
                System.arraycopy(state, 0, start[c], 0, block.count);
                begin(state, start[c], step, sum[c], weight, block.rate[c], block.count);
            }
        }
    }

    private static void begin(
            double[] state,
            double[] start,
            double step,
            double[] sum,
            double weight,
            double[] rate,
            int count) {
        for (int i = 0; i < count; i++) {
            sum[i] = start[i] + weight * rate[i];
            state[i] = start[i] + step * rate[i];
        }
    }

    /** Goes to the next stage, start + step * rate, and adds weight * rate to the sum. */
    private static void goOn(
            Block block, double[][] start, double step, double[][] sum, double weight) {
        boolean turns = block.turns();
        for (int c = 0; c < BodyState.COLUMNS; c++) {
            if (turns || !BodyState.isRotational(c)) {
                goOn(block.state[c], start[c], step, sum[c], weight, block.rate[c], block.count);
            }
        }
    }

    private static void goOn(
            double[] state,
            double[] start,
            double step,
            double[] sum,
            double weight,
            double[] rate,
            int count) {
        for (int i = 0; i < count; i++) {
            state[i] = start[i] + step * rate[i];
            sum[i] += weight * rate[i];
        }
    }

    /** The step's end: the sum of all stages. */
    private static void finish(Block block, double[][] sum, double weight) {
        boolean turns = block.turns();
        for (int c = 0; c < BodyState.COLUMNS; c++) {
            if (turns || !BodyState.isRotational(c)) {
                finish(block.state[c], sum[c], weight, block.rate[c], block.count);
            }
        }
    }

    /** A zero gets no sign, so that none depends on how zeros were added up. */
    private static void finish(
            double[] state, double[] sum, double weight, double[] rate, int count) {
        for (int i = 0; i < count; i++) {
            state[i] = sum[i] + weight * rate[i] + 0.0;
        }
    }
}
