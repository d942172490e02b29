package org.auvsim.diagnosis.measured;

import org.apache.commons.math3.fitting.leastsquares.LeastSquaresBuilder;
import org.apache.commons.math3.fitting.leastsquares.LeastSquaresOptimizer.Optimum;
import org.apache.commons.math3.fitting.leastsquares.LevenbergMarquardtOptimizer;
import org.apache.commons.math3.linear.Array2DRowRealMatrix;
import org.apache.commons.math3.linear.ArrayRealVector;
import org.apache.commons.math3.linear.RealMatrix;
import org.apache.commons.math3.linear.RealVector;
import org.apache.commons.math3.stat.regression.SimpleRegression;
import org.apache.commons.math3.util.Pair;

/**
 * Nomoto's model of first order, T dr/dt + r = K delta + c, fitted by simulation to a zigzag, its
 * start included; and sway in proportion to the yaw rate, v = a r + b, as a steady turn has it.
 */
record Nomoto(double time, double gain, double constant, double sway, double drift) {
    /** Where the search begins (s, 1/s); the best of their ends counts. */
    private static final double[][] STARTS = {
        {5, 0.1}, {20, 0.1}, {50, 0.3}, {20, -0.1}, {50, -0.5}
    };

    private static final double STEP = 1e-6;
    private static final int MOST = 2000;

    /** What was commanded and measured of a ship, evenly spaced (s; rad, rad/s, m/s). */
    @SuppressWarnings("ArrayRecordComponent") // used within this package, never compared
    record Zigzag(double spacing, double[] rudder, double[] yawRate, double[] sway) {}

    /** The best of a zigzag. */
    static Nomoto fitted(Zigzag zigzag) {
        double least = Double.POSITIVE_INFINITY;
        double[] best = {};
        for (double[] start : STARTS) {
            Optimum optimum = fit(zigzag, new double[] {start[0], start[1], 0, zigzag.yawRate[0]});
            if (optimum.getRMS() < least) {
                least = optimum.getRMS();
                best = optimum.getPoint().toArray();
            }
        }
        SimpleRegression regression = new SimpleRegression();
        for (int k = 0; k < zigzag.yawRate.length; k++) {
            regression.addData(zigzag.yawRate[k], zigzag.sway[k]);
        }
        return new Nomoto(
                best[0], best[1], best[2], regression.getSlope(), regression.getIntercept());
    }

    private static Optimum fit(Zigzag zigzag, double[] start) {
        return new LevenbergMarquardtOptimizer()
                .optimize(
                        new LeastSquaresBuilder()
                                .start(start)
                                .target(zigzag.yawRate)
                                .model(point -> linearised(zigzag, point))
                                .maxEvaluations(MOST)
                                .maxIterations(MOST)
                                .build());
    }

    private static Pair<RealVector, RealMatrix> linearised(Zigzag zigzag, RealVector point) {
        double[] p = point.toArray();
        double[] rates = rates(zigzag, p);
        RealMatrix slopes = new Array2DRowRealMatrix(rates.length, p.length);
        for (int c = 0; c < p.length; c++) {
            double step = STEP * Math.max(1, Math.abs(p[c]));
            double[] moved = p.clone();
            moved[c] += step;
            double[] there = rates(zigzag, moved);
            for (int k = 0; k < rates.length; k++) {
                slopes.setEntry(k, c, (there[k] - rates[k]) / step);
            }
        }
        return new Pair<>(new ArrayRealVector(rates, false), slopes);
    }

    /** Exact from row to row, as the rudder is held: time constant, gain, constant, first rate. */
    private static double[] rates(Zigzag zigzag, double[] p) {
        double[] rates = new double[zigzag.rudder.length];
        double kept = Math.exp(-zigzag.spacing / p[0]);
        rates[0] = p[3];
        for (int k = 1; k < rates.length; k++) {
            double steady = p[1] * zigzag.rudder[k - 1] + p[2];
            rates[k] = kept * rates[k - 1] + (1 - kept) * steady;
        }
        return rates;
    }

    /** The yaw rates (rad/s) that it predicts of another zigzag, from the start that fits best. */
    double[] yawRates(Zigzag zigzag) {
        double[] fromRest = rates(zigzag, new double[] {time, gain, constant, 0});
        double squares = 0;
        double product = 0;
        for (int k = 0; k < fromRest.length; k++) {
            double left = Math.exp(-k * zigzag.spacing / time);
            squares += left * left;
            product += left * (zigzag.yawRate[k] - fromRest[k]);
        }
        return rates(zigzag, new double[] {time, gain, constant, product / squares});
    }

    /** The sway (m/s) that goes with them. */
    double[] sway(Zigzag zigzag) {
        double[] rates = yawRates(zigzag);
        double[] sways = new double[rates.length];
        for (int k = 0; k < sways.length; k++) {
            sways[k] = sway * rates[k] + drift;
        }
        return sways;
    }
}
