package org.auvsim.diagnosis.fit;

import org.apache.commons.math3.linear.Array2DRowRealMatrix;
import org.apache.commons.math3.linear.ArrayRealVector;
import org.apache.commons.math3.linear.DecompositionSolver;
import org.apache.commons.math3.linear.SingularValueDecomposition;

import java.util.Arrays;
import java.util.List;

/**
 * All products of the library's columns with one another and with the misses, the starts projected
 * out: what any set of columns explains follows from it by a small solve.
 */
final class Gram {
    private final double[][] products;
    private final int misses;

    /** Of blocks of windows of all runs. */
    Gram(List<List<WindowBlock>> blocks, int columns) {
        products = new double[columns + 1][columns + 1];
        misses = columns;
        blocks.forEach(ofRun -> ofRun.forEach(block -> block.addGram(products)));
    }

    /** Sum of the squared misses that no change of the starts explains. */
    double cost() {
        return products[misses][misses];
    }

    /** The change of these parameters that explains most. */
    double[] solve(int[] columns) {
        int n = columns.length;
        double[][] matrix = new double[n][n];
        double[] right = new double[n];
        double[] scale = new double[n];
        for (int a = 0; a < n; a++) {
            scale[a] = Math.sqrt(Math.max(products[columns[a]][columns[a]], 1e-300));
        }
        for (int a = 0; a < n; a++) {
            for (int b = 0; b < n; b++) {
                matrix[a][b] = products[columns[a]][columns[b]] / scale[a] / scale[b];
            }
            right[a] = -products[columns[a]][misses] / scale[a];
        }
        DecompositionSolver solver =
                new SingularValueDecomposition(new Array2DRowRealMatrix(matrix, false)).getSolver();
        double[] solution = solver.solve(new ArrayRealVector(right, false)).toArray();
        for (int a = 0; a < n; a++) {
            solution[a] /= scale[a];
        }
        return solution;
    }

    /** By how much the cost falls with a change of these parameters. */
    double drop(int[] columns, double[] change) {
        double drop = 0;
        for (int a = 0; a < columns.length; a++) {
            drop -= 2 * change[a] * products[columns[a]][misses];
            for (int b = 0; b < columns.length; b++) {
                drop -= change[a] * products[columns[a]][columns[b]] * change[b];
            }
        }
        return drop;
    }

    /** The inverse of the products of these columns: the covariance of their parameters. */
    double[][] covariance(int[] columns) {
        double[][] matrix = new double[columns.length][columns.length];
        for (int a = 0; a < columns.length; a++) {
            for (int b = 0; b < columns.length; b++) {
                matrix[a][b] = products[columns[a]][columns[b]];
            }
        }
        return new SingularValueDecomposition(new Array2DRowRealMatrix(matrix, false))
                .getSolver()
                .getInverse()
                .getData();
    }

    @Override
    public String toString() {
        return "gram of %d columns, cost %s".formatted(misses, Arrays.toString(products[misses]));
    }
}
