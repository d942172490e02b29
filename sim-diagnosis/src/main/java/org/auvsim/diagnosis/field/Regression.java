package org.auvsim.diagnosis.field;

import org.apache.commons.math3.linear.EigenDecomposition;
import org.apache.commons.math3.linear.RealMatrix;
import org.apache.commons.math3.linear.RealVector;

/**
 * A linear regression whose weights are normally distributed around 0: both its deviations, that of
 * the weights and that of the noise, are those of the largest evidence (MacKay 1992, Bayesian
 * interpolation, Neural Computation 4).
 *
 * @param weights of the columns
 * @param evidence its logarithm, up to a constant that is the same for all columns
 */
record Regression(RealVector weights, double evidence) {
    private static final int ROUNDS = 40;

    /** A weight's and a misfit's square are at least such a share of the values': rounding. */
    private static final double LEAST = 1e-12;

    /** The regression of values on columns. */
    static Regression of(RealMatrix columns, RealVector values) {
        EigenDecomposition products = new EigenDecomposition(columns.transpose().multiply(columns));
        RealMatrix axes = products.getV();
        double[] eigenvalues = products.getRealEigenvalues();
        RealVector along = axes.preMultiply(columns.preMultiply(values));
        int count = values.getDimension();
        double size = values.dotProduct(values);
        double prior = 1;
        double precision = count / size;
        RealVector weights = along;
        double evidence = Double.NEGATIVE_INFINITY;
        for (int round = 0; round < ROUNDS; round++) {
            RealVector rotated = along.copy();
            double determined = 0;
            double determinant = 0;
            for (int i = 0; i < eigenvalues.length; i++) {
                double told = precision * Math.max(0, eigenvalues[i]);
                rotated.setEntry(i, precision * along.getEntry(i) / (told + prior));
                determined += told / (told + prior);
                determinant += StrictMath.log(told + prior);
            }
            weights = axes.operate(rotated);
            double square = Math.max(weights.dotProduct(weights), LEAST * size);
            RealVector left = values.subtract(columns.operate(weights));
            double misfit = Math.max(left.dotProduct(left), LEAST * size);
            evidence =
                    (eigenvalues.length * StrictMath.log(prior)
                                    + count * StrictMath.log(precision)
                                    - precision * misfit
                                    - prior * square
                                    - determinant)
                            / 2;
            prior = determined / square;
            precision = Math.max(1, count - determined) / misfit;
        }
        return new Regression(weights, evidence);
    }

    /** The evidence of no columns at all: the values are noise. */
    static double evidenceOfNothing(RealVector values) {
        int count = values.getDimension();
        return (count * StrictMath.log(count / values.dotProduct(values)) - count) / 2;
    }
}
