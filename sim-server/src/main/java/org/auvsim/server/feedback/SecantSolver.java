package org.auvsim.server.feedback;

import org.apache.commons.math3.linear.ArrayRealVector;
import org.apache.commons.math3.linear.DecompositionSolver;
import org.apache.commons.math3.linear.LUDecomposition;
import org.apache.commons.math3.linear.MatrixUtils;
import org.apache.commons.math3.linear.RealMatrix;
import org.apache.commons.math3.linear.RealVector;

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

    /** A pivot below this counts as zero. */
    private static final double SINGULAR = 1e-12;

    private final Function<double[], Optional<double[]>> residual;
    private RealMatrix inverse;
    private boolean isMeasured;
    private RealVector at;
    private RealVector missed;

    private SecantSolver(Function<double[], Optional<double[]>> residual, int n) {
        this.residual = residual;
        inverse = MatrixUtils.createRealIdentityMatrix(n);
        at = new ArrayRealVector(n);
        missed = residual(at).orElseGet(() -> new ArrayRealVector(1, Double.POSITIVE_INFINITY));
    }

    /** What is missed with these unknowns; empty where that is no number. */
    private Optional<RealVector> residual(RealVector unknowns) {
        return residual.apply(unknowns.toArray())
                .<RealVector>map(ArrayRealVector::new)
                .filter(numbers -> !numbers.isNaN());
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
        return at.toArray();
    }

    /** The size of the residual there; infinite if nothing could be tried. */
    double missed() {
        return missed.getNorm();
    }

    /** Whether nothing is left of the residual. */
    boolean isExact() {
        return missed() <= TOLERANCE;
    }

    private boolean isBeside() {
        return missed() > TOLERANCE && missed() < Double.POSITIVE_INFINITY;
    }

    /** One step; false if none in this direction brings anything. */
    private boolean step() {
        RealVector full = inverse.operate(missed);
        double share = 1;
        for (int halvings = 0; halvings <= MOST_HALVINGS; halvings++) {
            RealVector change = full.mapMultiply(-share);
            RealVector to = at.add(change);
            Optional<RealVector> there = residual(to);
            if (there.isPresent()) {
                learn(change, there.get().subtract(missed));
                if (there.get().getNorm() < missed()) {
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
    private void learn(RealVector change, RealVector answer) {
        RealVector predicted = inverse.operate(answer);
        double scale = change.dotProduct(predicted);
        if (Math.abs(scale) < 0.1 * change.dotProduct(change)) {
            return; // an answer that says too little, as a jump at a collision
        }
        RealVector wrong = change.subtract(predicted).mapMultiply(1 / scale);
        inverse = inverse.add(wrong.outerProduct(inverse.preMultiply(change)));
    }

    /** Measures the Jacobian here; false if it was just measured here or cannot be inverted. */
    private boolean measure() {
        if (isMeasured) {
            return false;
        }
        isMeasured = true;
        int n = at.getDimension();
        RealMatrix jacobian = MatrixUtils.createRealMatrix(n, n);
        for (int j = 0; j < n; j++) {
            RealVector to = at.copy();
            to.addToEntry(j, DIFFERENCE);
            Optional<RealVector> there = residual(to);
            if (there.isEmpty()) {
                return false;
            }
            jacobian.setColumnVector(j, there.get().subtract(missed).mapDivide(DIFFERENCE));
        }
        DecompositionSolver solver = new LUDecomposition(jacobian, SINGULAR).getSolver();
        if (solver.isNonSingular()) {
            inverse = solver.getInverse();
        }
        return solver.isNonSingular();
    }
}
