package org.auvsim.auvsml.message.feedback;

import org.auvsim.core.math.Cholesky;
import org.auvsim.core.math.Numbers;

import java.util.Arrays;
import java.util.List;

/**
 * How far a measurement may be off: the covariance of its errors, symmetric and positive definite,
 * in the units of what is measured (m, rad, m/s, rad/s).
 *
 * @param row its rows, each with as many numbers as there are rows
 */
public record Covariance(List<CovarianceRow> row) {
    /** How far mirror images may differ, relative to the geometric mean of the variances. */
    private static final double ASYMMETRY = 1e-6;

    /**
     * A checked covariance.
     *
     * @throws IllegalArgumentException if it is not square, finite, symmetric or positive definite;
     *     the sentence names the row
     */
    public Covariance {
        row = List.copyOf(row);
        requireSquare(row);
        requireSymmetric(row);
        try {
            new Cholesky(elements(row));
        } catch (IllegalArgumentException e) {
            throw new IllegalArgumentException(
                    "a covariance must be positive definite, but " + e.getMessage(), e);
        }
    }

    /** Independent errors of these variances. */
    public static Covariance diagonal(double... variances) {
        double[] elements = new double[variances.length * variances.length];
        for (int i = 0; i < variances.length; i++) {
            elements[(variances.length + 1) * i] = variances[i];
        }
        return of(elements, variances.length);
    }

    /**
     * The covariance of these elements, row by row.
     *
     * @param size number of rows and columns
     */
    public static Covariance of(double[] elements, int size) {
        CovarianceRow[] rows = new CovarianceRow[size];
        Arrays.setAll(
                rows,
                i ->
                        new CovarianceRow(
                                Numbers.of(
                                        Arrays.copyOfRange(elements, size * i, size * (i + 1)))));
        return new Covariance(List.of(rows));
    }

    private static void requireSquare(List<CovarianceRow> rows) {
        if (rows.isEmpty()) {
            throw new IllegalArgumentException("a covariance must have rows, but has none");
        }
        int columns = rows.getFirst().values().size();
        if (columns != rows.size()
                && rows.stream().allMatch(each -> each.values().size() == columns)) {
            throw new IllegalArgumentException(
                    "a covariance with rows of %d numbers must have %d rows of %d numbers,"
                                    .formatted(columns, columns, columns)
                            + " but has %d".formatted(rows.size()));
        }
        for (int i = 0; i < rows.size(); i++) {
            int length = rows.get(i).values().size();
            if (length != rows.size()) {
                throw new IllegalArgumentException(
                        "each row of a covariance of %d rows must have %d numbers, but"
                                        .formatted(rows.size(), rows.size())
                                + " row %d has %d".formatted(i + 1, length));
            }
        }
    }

    private static void requireSymmetric(List<CovarianceRow> rows) {
        for (int i = 0; i < rows.size(); i++) {
            for (int j = 0; j < i; j++) {
                double own = at(rows, i, j);
                double mirror = at(rows, j, i);
                double scale = Math.sqrt(Math.abs(at(rows, i, i) * at(rows, j, j)));
                if (!(Math.abs(own - mirror) <= ASYMMETRY * scale)) {
                    throw new IllegalArgumentException(
                            "a covariance must be symmetric, but row %d has %s in column %d"
                                            .formatted(i + 1, own, j + 1)
                                    + " and row %d has %s in column %d"
                                            .formatted(j + 1, mirror, i + 1));
                }
            }
        }
    }

    private static double at(List<CovarianceRow> rows, int i, int j) {
        return rows.get(i).values().get(j);
    }

    private static double[][] elements(List<CovarianceRow> rows) {
        int size = rows.size();
        double[][] elements = new double[size][size];
        for (int i = 0; i < size; i++) {
            for (int j = 0; j < size; j++) {
                elements[i][j] = at(rows, i, j) / 2 + at(rows, j, i) / 2;
            }
        }
        return elements;
    }

    /** Number of rows and columns. */
    public int size() {
        return row.size();
    }

    /** Its rows, exactly symmetric. */
    public double[][] elements() {
        return elements(row);
    }
}
