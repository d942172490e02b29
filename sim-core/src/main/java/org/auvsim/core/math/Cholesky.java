package org.auvsim.core.math;

/**
 * The factor L of a symmetric, positive definite matrix M = L L^T (Golub &amp; Van Loan 2013,
 * section 4.2); matrices are arrays of rows.
 */
public final class Cholesky {
    /** A pivot below this share of its diagonal element is rounding. */
    private static final double ROUNDING = 1e-13;

    private final double[][] factor;

    /**
     * Factorises a matrix, of which only the lower triangle is read.
     *
     * @throws IllegalArgumentException if it is not positive definite, naming the row that fails
     */
    public Cholesky(double[][] matrix) {
        int size = matrix.length;
        factor = new double[size][size];
        for (int i = 0; i < size; i++) {
            for (int j = 0; j <= i; j++) {
                double left = matrix[i][j] - rowProduct(i, j);
                factor[i][j] =
                        i == j ? Math.sqrt(positive(left, matrix[i][i], i)) : left / factor[j][j];
            }
        }
    }

    private double rowProduct(int i, int j) {
        double sum = 0;
        for (int k = 0; k < j; k++) {
            sum += factor[i][k] * factor[j][k];
        }
        return sum;
    }

    private static double positive(double pivot, double diagonal, int row) {
        if (!(pivot > ROUNDING * Math.abs(diagonal)) || Double.isInfinite(pivot)) {
            throw new IllegalArgumentException(
                    "row %d has %s on the diagonal, where more than %s is needed"
                            .formatted(row + 1, diagonal, diagonal - pivot));
        }
        return pivot;
    }

    /** The x for which M x = {@code b}. */
    public double[] solve(double[] b) {
        double[] x = b.clone();
        int size = factor.length;
        for (int i = 0; i < size; i++) {
            for (int k = 0; k < i; k++) {
                x[i] -= factor[i][k] * x[k];
            }
            x[i] /= factor[i][i];
        }
        for (int i = size - 1; i >= 0; i--) {
            for (int k = i + 1; k < size; k++) {
                x[i] -= factor[k][i] * x[k];
            }
            x[i] /= factor[i][i];
        }
        return x;
    }
}
