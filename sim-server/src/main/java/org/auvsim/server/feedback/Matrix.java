package org.auvsim.server.feedback;

import org.auvsim.core.math.Mat3;

import java.util.Arrays;
import java.util.List;
import java.util.Optional;

/** A dense matrix; an immutable value. */
public final class Matrix {
    /** A pivot below this counts as zero. */
    private static final double SINGULAR = 1e-12;

    private final int rows;
    private final int columns;
    private final double[] elements;

    private Matrix(int rows, int columns, double[] elements) {
        this.rows = rows;
        this.columns = columns;
        this.elements = elements;
    }

    /**
     * The matrix with these elements, row by row.
     *
     * @throws IllegalArgumentException if they do not fill the rows
     */
    public static Matrix of(double[] elements, int rows) {
        if (rows < 1 || elements.length == 0 || elements.length % rows != 0) {
            throw new IllegalArgumentException(
                    "%d elements do not fill %d rows".formatted(elements.length, rows));
        }
        return new Matrix(rows, elements.length / rows, elements.clone());
    }

    /** Zeros beside these numbers on the diagonal. */
    public static Matrix diagonal(double... numbers) {
        int n = numbers.length;
        double[] elements = new double[n * n];
        for (int i = 0; i < n; i++) {
            elements[(n + 1) * i] = numbers[i];
        }
        return new Matrix(n, n, elements);
    }

    static Matrix identity(int size) {
        double[] ones = new double[size];
        Arrays.fill(ones, 1);
        return diagonal(ones);
    }

    /** Zeros beside these blocks on the diagonal. */
    static Matrix blocks(List<Mat3> blocks) {
        int n = 3 * blocks.size();
        double[] elements = new double[n * n];
        for (int k = 0; k < blocks.size(); k++) {
            Mat3 m = blocks.get(k);
            double[] block = {
                m.xx(), m.xy(), m.xz(), m.yx(), m.yy(), m.yz(), m.zx(), m.zy(), m.zz()
            };
            for (int i = 0; i < 3; i++) {
                System.arraycopy(block, 3 * i, elements, n * (3 * k + i) + 3 * k, 3);
            }
        }
        return new Matrix(n, n, elements);
    }

    /** Number of rows. */
    public int rows() {
        return rows;
    }

    /** Number of columns. */
    public int columns() {
        return columns;
    }

    /** An element, counted from 0. */
    public double at(int row, int column) {
        return elements[columns * row + column];
    }

    /** The elements, row by row. */
    public double[] elements() {
        return elements.clone();
    }

    /** This * {@code o}. */
    public Matrix times(Matrix o) {
        double[] product = new double[rows * o.columns];
        for (int i = 0; i < rows; i++) {
            for (int k = 0; k < columns; k++) {
                double factor = elements[columns * i + k];
                for (int j = 0; j < o.columns; j++) {
                    product[o.columns * i + j] += factor * o.elements[o.columns * k + j];
                }
            }
        }
        return new Matrix(rows, o.columns, product);
    }

    /** This * the column vector {@code v}. */
    public double[] times(double[] v) {
        return times(of(v, v.length)).elements;
    }

    /** This + {@code o}. */
    public Matrix plus(Matrix o) {
        double[] sum = elements.clone();
        for (int i = 0; i < sum.length; i++) {
            sum[i] += o.elements[i];
        }
        return new Matrix(rows, columns, sum);
    }

    /** This - {@code o}. */
    public Matrix minus(Matrix o) {
        double[] difference = elements.clone();
        for (int i = 0; i < difference.length; i++) {
            difference[i] -= o.elements[i];
        }
        return new Matrix(rows, columns, difference);
    }

    /** Rows and columns exchanged. */
    public Matrix transposed() {
        double[] turned = new double[elements.length];
        for (int i = 0; i < rows; i++) {
            for (int j = 0; j < columns; j++) {
                turned[rows * j + i] = elements[columns * i + j];
            }
        }
        return new Matrix(columns, rows, turned);
    }

    /** M * this * M^T: how a covariance becomes that of M x. */
    Matrix within(Matrix m) {
        return m.times(this).times(m.transposed()).symmetric();
    }

    /** The mean of this and its transposed: takes rounding off a symmetric matrix. */
    Matrix symmetric() {
        Matrix twice = plus(transposed());
        for (int i = 0; i < twice.elements.length; i++) {
            twice.elements[i] /= 2;
        }
        return twice;
    }

    /** The inverse, by Gauss and Jordan's elimination with pivots; empty if it is singular. */
    Optional<Matrix> inverse() {
        double[][] left = new double[rows][];
        double[][] right = new double[rows][];
        Matrix identity = identity(rows);
        for (int i = 0; i < rows; i++) {
            left[i] = Arrays.copyOfRange(elements, rows * i, rows * (i + 1));
            right[i] = Arrays.copyOfRange(identity.elements, rows * i, rows * (i + 1));
        }
        for (int k = 0; k < rows; k++) {
            swapToPivot(left, right, k);
            if (!(Math.abs(left[k][k]) > SINGULAR)) {
                return Optional.empty();
            }
            eliminate(left, right, k);
        }
        double[] inverted = Arrays.stream(right).flatMapToDouble(Arrays::stream).toArray();
        return Optional.of(new Matrix(rows, rows, inverted));
    }

    private static void swapToPivot(double[][] left, double[][] right, int k) {
        int pivot = k;
        for (int i = k + 1; i < left.length; i++) {
            pivot = Math.abs(left[i][k]) > Math.abs(left[pivot][k]) ? i : pivot;
        }
        double[] row = left[k];
        left[k] = left[pivot];
        left[pivot] = row;
        row = right[k];
        right[k] = right[pivot];
        right[pivot] = row;
    }

    private static void eliminate(double[][] left, double[][] right, int k) {
        double pivot = left[k][k];
        for (int j = 0; j < left.length; j++) {
            left[k][j] /= pivot;
            right[k][j] /= pivot;
        }
        for (int i = 0; i < left.length; i++) {
            double factor = left[i][k];
            for (int j = 0; i != k && j < left.length; j++) {
                left[i][j] -= factor * left[k][j];
                right[i][j] -= factor * right[k][j];
            }
        }
    }

    boolean isFinite() {
        return Arrays.stream(elements).allMatch(Double::isFinite);
    }

    @Override
    public boolean equals(Object other) {
        return other instanceof Matrix m && rows == m.rows && Arrays.equals(elements, m.elements);
    }

    @Override
    public int hashCode() {
        return Arrays.hashCode(elements);
    }

    @Override
    public String toString() {
        return rows + "x" + columns + Arrays.toString(elements);
    }
}
