package org.auvsim.server.feedback;

import java.util.Optional;
import java.util.function.Function;

/**
 * Solves n equations for n unknowns by Broyden's method (C. G. Broyden, Math. Comp. 19, 1965), with
 * steps that are halved until they bring something. The equations must be scaled so that an unknown
 * changes its own equation about as much as itself, and the others little.
 */
final class SecantSolver {
    /** The size of the residual (m) that counts as none. */
    static final double TOLERANCE = 1e-9;

    private static final int MOST_STEPS = 30;
    private static final int MOST_HALVINGS = 10;

    private final Function<double[], Optional<double[]>> residual;
    private final double[][] inverse;
    private double[] at;
    private double[] missed;

    private SecantSolver(Function<double[], Optional<double[]>> residual, int n) {
        this.residual = residual;
        this.inverse = new double[n][n];
        for (int i = 0; i < n; i++) {
            inverse[i][i] = 1;
        }
        at = new double[n];
        missed = residual.apply(at).orElseGet(() -> new double[] {Double.POSITIVE_INFINITY});
    }

    /**
     * The unknowns with the smallest residual that was found, starting at zero.
     *
     * @param residual empty where there is none
     */
    static double[] solve(Function<double[], Optional<double[]>> residual, int unknowns) {
        SecantSolver solver = new SecantSolver(residual, unknowns);
        int steps = 0;
        while (steps < MOST_STEPS && solver.isBeside() && solver.step()) {
            steps++;
        }
        return solver.at;
    }

    private boolean isBeside() {
        double norm = norm(missed);
        return norm > TOLERANCE && norm < Double.POSITIVE_INFINITY;
    }

    /** One step; false if none in this direction brings anything. */
    private boolean step() {
        double[] full = times(inverse, missed);
        double share = 1;
        for (int halvings = 0; halvings <= MOST_HALVINGS; halvings++) {
            double[] change = scaled(full, -share);
            double[] to = sum(at, change);
            Optional<double[]> there = residual.apply(to);
            if (there.isPresent()) {
                learn(change, sum(there.get(), scaled(missed, -1)));
                if (norm(there.get()) < norm(missed)) {
                    at = to;
                    missed = there.get();
                    return true;
                }
            }
            share /= 2;
        }
        return false;
    }

    /** Broyden's update of the inverse Jacobian, in Sherman and Morrison's form. */
    private void learn(double[] change, double[] answer) {
        int n = change.length;
        double[] predicted = times(inverse, answer);
        double[] row = new double[n];
        for (int j = 0; j < n; j++) {
            for (int i = 0; i < n; i++) {
                row[j] += change[i] * inverse[i][j];
            }
        }
        double scale = dot(change, predicted);
        if (Math.abs(scale) < 0.1 * dot(change, change)) {
            return; // an answer that says too little, as a jump at a collision
        }
        for (int i = 0; i < n; i++) {
            for (int j = 0; j < n; j++) {
                inverse[i][j] += (change[i] - predicted[i]) * row[j] / scale;
            }
        }
    }

    private static double[] times(double[][] matrix, double[] v) {
        double[] product = new double[v.length];
        for (int i = 0; i < v.length; i++) {
            product[i] = dot(matrix[i], v);
        }
        return product;
    }

    private static double dot(double[] a, double[] b) {
        double sum = 0;
        for (int i = 0; i < a.length; i++) {
            sum += a[i] * b[i];
        }
        return sum;
    }

    private static double norm(double[] v) {
        return Math.sqrt(dot(v, v));
    }

    private static double[] scaled(double[] v, double factor) {
        double[] scaled = new double[v.length];
        for (int i = 0; i < v.length; i++) {
            scaled[i] = v[i] * factor;
        }
        return scaled;
    }

    private static double[] sum(double[] a, double[] b) {
        double[] sum = new double[a.length];
        for (int i = 0; i < a.length; i++) {
            sum[i] = a[i] + b[i];
        }
        return sum;
    }
}
