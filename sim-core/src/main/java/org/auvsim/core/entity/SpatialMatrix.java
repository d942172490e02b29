package org.auvsim.core.entity;

import org.auvsim.core.math.Mat3;
import org.auvsim.core.math.Vec3;

import java.util.Arrays;

/** Symmetric 6x6 matrices as arrays of 36 numbers, row by row; translations before rotations. */
final class SpatialMatrix {
    private SpatialMatrix() {}

    static void setDiagonal(double[] m, Vec3 linear, Vec3 angular) {
        m[0] = linear.x();
        m[7] = linear.y();
        m[14] = linear.z();
        m[21] = angular.x();
        m[28] = angular.y();
        m[35] = angular.z();
    }

    /**
     * The inertia of a rigid body about its origin (Fossen 2021, section 3.3).
     *
     * @param r centre of mass (m, body)
     * @param inertia about the centre of mass (kg m^2)
     */
    static double[] rigid(double mass, Vec3 r, Mat3 inertia) {
        double[] m = new double[36];
        double rr = r.dot(r);
        setDiagonal(
                m,
                new Vec3(mass, mass, mass),
                new Vec3(
                        inertia.xx() + mass * (rr - r.x() * r.x()),
                        inertia.yy() + mass * (rr - r.y() * r.y()),
                        inertia.zz() + mass * (rr - r.z() * r.z())));
        setPair(m, 3, 4, inertia.xy() - mass * r.x() * r.y());
        setPair(m, 3, 5, inertia.xz() - mass * r.x() * r.z());
        setPair(m, 4, 5, inertia.yz() - mass * r.y() * r.z());
        setPair(m, 0, 4, mass * r.z());
        setPair(m, 0, 5, -mass * r.y());
        setPair(m, 1, 3, -mass * r.z());
        setPair(m, 1, 5, mass * r.x());
        setPair(m, 2, 3, mass * r.y());
        setPair(m, 2, 4, -mass * r.x());
        return m;
    }

    private static void setPair(double[] m, int row, int column, double value) {
        m[6 * row + column] = value;
        m[6 * column + row] = value;
    }

    static double[] sum(double[] a, double[] b) {
        double[] sum = new double[36];
        for (int i = 0; i < 36; i++) {
            sum[i] = a[i] + b[i];
        }
        return sum;
    }

    /** The inverse of a positive definite matrix. */
    static double[] inverse(double[] m) {
        double[] factor = m.clone();
        factor(factor, 0, 6);
        double[] inverse = new double[36];
        double[] column = new double[6];
        for (int c = 0; c < 6; c++) {
            Arrays.fill(column, 0);
            column[c] = 1;
            solve(factor, 0, 6, column, 0);
            for (int r = 0; r < 6; r++) {
                inverse[6 * r + c] = column[r];
            }
        }
        for (int r = 0; r < 6; r++) {
            for (int c = 0; c < r; c++) {
                setPair(inverse, r, c, (inverse[6 * r + c] + inverse[6 * c + r]) / 2);
            }
        }
        return inverse;
    }

    /**
     * Cholesky's factor in place of the first {@code n} rows and columns of 6, from an index on.
     */
    static void factor(double[] m, int at, int n) {
        for (int j = 0; j < n; j++) {
            for (int i = j; i < n; i++) {
                double sum = m[at + 6 * i + j];
                for (int k = 0; k < j; k++) {
                    sum -= m[at + 6 * i + k] * m[at + 6 * j + k];
                }
                m[at + 6 * i + j] = i == j ? Math.sqrt(sum) : sum / m[at + 6 * j + j];
            }
        }
    }

    /** Solves in place with a factor. */
    static void solve(double[] factor, int at, int n, double[] x, int from) {
        for (int i = 0; i < n; i++) {
            for (int k = 0; k < i; k++) {
                x[from + i] -= factor[at + 6 * i + k] * x[from + k];
            }
            x[from + i] /= factor[at + 6 * i + i];
        }
        for (int i = n - 1; i >= 0; i--) {
            for (int k = i + 1; k < n; k++) {
                x[from + i] -= factor[at + 6 * k + i] * x[from + k];
            }
            x[from + i] /= factor[at + 6 * i + i];
        }
    }
}
