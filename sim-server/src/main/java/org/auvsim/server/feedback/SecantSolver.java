package org.auvsim.server.feedback;

import java.util.Optional;
import java.util.function.Function;

/**
 * Solves n equations for n unknowns by Newton's method with steps that are halved until they bring
 * something. Its Jacobian starts as the identity and learns from each step (C. G. Broyden, Math.
 * Comp. 19, 1965); where that no longer brings anything, it is measured anew by differences. The
 * equations must be scaled so that an unknown changes its own equation about as much as itself.
 */
final class SecantSolver {
    /** The size of the residual that counts as none. */
    static final double TOLERANCE = 1e-9;

    private static final int MOST_STEPS = 30;
    private static final int MOST_HALVINGS = 10;

    /** By how much an unknown is changed to measure what it does. */
    private static final double DIFFERENCE = 1e-6;

    private final Function<double[], Optional<double[]>> residual;
    private Matrix inverse;
    private boolean isMeasured;
    private double[] at;
    private double[] missed;

    private SecantSolver(Function<double[], Optional<double[]>> residual, int n) {
        this.residual = residual;
        inverse = Matrix.identity(n);
        at = new double[n];
        missed = residual.apply(at).orElseGet(() -> new double[] {Double.POSITIVE_INFINITY});
    }

    /**
     * Looks for the unknowns with the smallest residual, starting at zero.
     *
     * @param residual empty where there is none
     */
    static SecantSolver solve(Function<double[], Optional<double[]>> residual, int unknowns) {
        SecantSolver solver = new SecantSolver(residual, unknowns);
        int steps = 0;
        while (steps < MOST_STEPS
                && solver.isBeside()
                && (solver.step() || (solver.measure() && solver.step()))) {
            steps++;
        }
        return solver;
    }

    /** The unknowns that were found. */
    double[] found() {
        return at.clone();
    }

    /** The size of the residual there; infinite if nothing could be tried. */
    double missed() {
        return norm(missed);
    }

    /** Whether nothing is left of the residual. */
    boolean isExact() {
        return missed() <= TOLERANCE;
    }

    private boolean isBeside() {
        double norm = norm(missed);
        return norm > TOLERANCE && norm < Double.POSITIVE_INFINITY;
    }

    /** One step; false if none in this direction brings anything. */
    private boolean step() {
        double[] full = inverse.times(missed);
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
                    isMeasured = false;
                    return true;
                }
            }
            share /= 2;
        }
        return false;
    }

    /** Broyden's update of the inverse Jacobian, in Sherman and Morrison's form. */
    private void learn(double[] change, double[] answer) {
        double[] predicted = inverse.times(answer);
        double scale = dot(change, predicted);
        if (Math.abs(scale) < 0.1 * dot(change, change)) {
            return; // an answer that says too little, as a jump at a collision
        }
        double[] wrong = scaled(sum(change, scaled(predicted, -1)), 1 / scale);
        Matrix row = Matrix.of(change, 1).times(inverse);
        inverse = inverse.plus(Matrix.of(wrong, wrong.length).times(row));
    }

    /** Measures the Jacobian here; false if it was just measured here or cannot be inverted. */
    private boolean measure() {
        if (isMeasured) {
            return false;
        }
        isMeasured = true;
        int n = at.length;
        double[] jacobian = new double[n * n];
        for (int j = 0; j < n; j++) {
            double[] to = at.clone();
            to[j] += DIFFERENCE;
            Optional<double[]> there = residual.apply(to);
            if (there.isEmpty()) {
                return false;
            }
            for (int i = 0; i < n; i++) {
                jacobian[n * i + j] = (there.get()[i] - missed[i]) / DIFFERENCE;
            }
        }
        Optional<Matrix> inverted = Matrix.of(jacobian, n).inverse();
        inverted.ifPresent(m -> inverse = m);
        return inverted.isPresent();
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
