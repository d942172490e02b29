package org.auvsim.experiments.thesis;

import org.apache.commons.math3.stat.regression.OLSMultipleLinearRegression;

import java.util.Arrays;
import java.util.List;

/**
 * A polynomial through points by least squares.
 *
 * @param coefficients from the constant one up
 * @param rSquared the share of the variance that it explains: 1 if it goes through all points
 */
public record PolynomialFit(List<Double> coefficients, double rSquared) {
    /**
     * The one of a degree that fits best.
     *
     * @throws IllegalArgumentException if there are not more points than coefficients, or the two
     *     arrays differ in length
     */
    public static PolynomialFit of(double[] x, double[] y, int degree) {
        if (x.length != y.length || x.length < degree + 2) {
            throw new IllegalArgumentException(
                    "a polynomial of degree %d needs %d or more points, but has %d and %d numbers"
                            .formatted(degree, degree + 2, x.length, y.length));
        }
        double[][] powers = new double[x.length][degree];
        for (int i = 0; i < x.length; i++) {
            double power = 1;
            for (int k = 0; k < degree; k++) {
                power *= x[i];
                powers[i][k] = power;
            }
        }
        OLSMultipleLinearRegression regression = new OLSMultipleLinearRegression();
        regression.newSampleData(y, powers);
        List<Double> found =
                Arrays.stream(regression.estimateRegressionParameters()).boxed().toList();
        return new PolynomialFit(found, regression.calculateRSquared());
    }

    /** Its value. */
    public double at(double x) {
        double sum = 0;
        for (int k = coefficients.size() - 1; k >= 0; k--) {
            sum = sum * x + coefficients.get(k);
        }
        return sum;
    }

    /** The coefficient of the highest power. */
    public double leading() {
        return coefficients.getLast();
    }
}
