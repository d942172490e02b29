package org.auvsim.core.math;

/** Quadratic forms x^T M x, with the matrix M row by row in an array. */
public final class QuadraticForm {
    /** What an element on the diagonal may be below zero by rounding, relative to the largest. */
    private static final double ROUNDING = 1e-12;

    private QuadraticForm() {}

    /**
     * Whether x^T M x is 0 or more for all x: Gauss's elimination, largest pivot first, of the
     * symmetric part of M, which alone counts.
     *
     * @param size number of rows and columns
     */
    public static boolean isSemiDefinite(double[] matrix, int size) {
        double[] m = symmetricPart(matrix, size);
        double largest = 0;
        for (int i = 0; i < size; i++) {
            largest = Math.max(largest, Math.abs(m[(size + 1) * i]));
        }
        double least = ROUNDING * largest;
        boolean[] done = new boolean[size];
        for (int step = 0; step < size; step++) {
            int pivot = pivot(m, done);
            if (!(m[(size + 1) * pivot] > least)) {
                return restIsZero(m, done, least);
            }
            done[pivot] = true;
            eliminate(m, done, pivot);
        }
        return true;
    }

    private static double[] symmetricPart(double[] matrix, int size) {
        double[] m = new double[size * size];
        for (int i = 0; i < size; i++) {
            for (int j = 0; j < size; j++) {
                m[size * i + j] = matrix[size * i + j] / 2 + matrix[size * j + i] / 2;
            }
        }
        return m;
    }

    private static int pivot(double[] m, boolean[] done) {
        int pivot = -1;
        for (int i = 0; i < done.length; i++) {
            if (!done[i]
                    && (pivot < 0 || m[(done.length + 1) * i] > m[(done.length + 1) * pivot])) {
                pivot = i;
            }
        }
        return pivot;
    }

    private static void eliminate(double[] m, boolean[] done, int pivot) {
        int size = done.length;
        for (int i = 0; i < size; i++) {
            for (int j = 0; j < size; j++) {
                if (!done[i] && !done[j]) {
                    m[size * i + j] -=
                            m[size * i + pivot] * m[size * pivot + j] / m[(size + 1) * pivot];
                }
            }
        }
    }

    private static boolean restIsZero(double[] m, boolean[] done, double least) {
        int size = done.length;
        for (int i = 0; i < size; i++) {
            for (int j = 0; j < size; j++) {
                if (!done[i] && !done[j] && !(Math.abs(m[size * i + j]) <= least)) {
                    return false;
                }
            }
        }
        return true;
    }
}
