package org.auvsim.server.feedback;

import org.auvsim.core.math.Cholesky;

import java.util.ArrayList;
import java.util.List;

/**
 * One measurement in an extended Kalman filter on the error of a rigid body's motion.
 *
 * @param motion the estimate with it
 * @param covariance of that estimate's error
 * @param surprise the innovation squared, in units of its covariance
 */
record KalmanUpdate(RigidMotion motion, Matrix covariance, double surprise) {
    /**
     * Uses a measurement, with the covariance in Joseph's form (Bucy &amp; Joseph 1968), which
     * stays positive definite whatever is rounded; what the correction of the orientation changes
     * in the axes of its error is of second order and left out (Sol&agrave;, "Quaternion kinematics
     * for the error-state Kalman filter", 2017, section 6.3).
     *
     * @param predicted covariance of the model's error
     * @param noise covariance of what was measured
     * @throws IllegalArgumentException if the two are so far apart that they cannot be weighed
     */
    static KalmanUpdate of(RigidMotion model, Matrix predicted, Target measured, Matrix noise) {
        int[] rows = rows(measured);
        double[] innovation = picked(measured.replacing(model).minus(model), rows);
        Matrix pick = pick(rows);
        Matrix carried = predicted.times(pick.transposed());
        Cholesky size = factor(pick.times(carried).plus(noise));
        Matrix gain = gain(carried, size);
        Matrix left = Matrix.identity(RigidMotion.SIZE).minus(gain.times(pick));
        return new KalmanUpdate(
                model.plus(gain.times(innovation)),
                predicted.within(left).plus(noise.within(gain)),
                dot(innovation, size.solve(innovation)));
    }

    private static Cholesky factor(Matrix expected) {
        try {
            return new Cholesky(expected.elements(), expected.rows());
        } catch (IllegalArgumentException e) {
            throw new IllegalArgumentException(
                    "the errors of model and measurement cannot be weighed against each other,"
                            + " since in their sum one is lost in the other's rounding; state a"
                            + " larger covariance ("
                            + e.getMessage()
                            + ")",
                    e);
        }
    }

    /** The rows of a 12 x 12 covariance that belong to what was measured. */
    static Matrix measured(Target target, Matrix covariance) {
        return covariance.within(pick(rows(target)));
    }

    /** P H^T S^-1, by the factor of S. */
    private static Matrix gain(Matrix carried, Cholesky size) {
        int columns = carried.columns();
        double[] gain = new double[carried.rows() * columns];
        for (int i = 0; i < carried.rows(); i++) {
            double[] row = new double[columns];
            for (int j = 0; j < columns; j++) {
                row[j] = carried.at(i, j);
            }
            System.arraycopy(size.solve(row), 0, gain, columns * i, columns);
        }
        return Matrix.of(gain, carried.rows());
    }

    private static int[] rows(Target target) {
        List<Boolean> there =
                List.of(
                        target.position().isPresent(),
                        target.orientation().isPresent(),
                        target.velocity().isPresent(),
                        target.angularVelocity().isPresent());
        List<Integer> rows = new ArrayList<>();
        for (int i = 0; i < RigidMotion.SIZE; i++) {
            if (there.get(i / 3)) {
                rows.add(i);
            }
        }
        return rows.stream().mapToInt(i -> i).toArray();
    }

    /** H: ones where a row belongs to a number of the motion's error. */
    private static Matrix pick(int[] rows) {
        double[] pick = new double[rows.length * RigidMotion.SIZE];
        for (int i = 0; i < rows.length; i++) {
            pick[RigidMotion.SIZE * i + rows[i]] = 1;
        }
        return Matrix.of(pick, rows.length);
    }

    private static double[] picked(double[] numbers, int[] rows) {
        double[] picked = new double[rows.length];
        for (int i = 0; i < rows.length; i++) {
            picked[i] = numbers[rows[i]];
        }
        return picked;
    }

    private static double dot(double[] a, double[] b) {
        double sum = 0;
        for (int i = 0; i < a.length; i++) {
            sum += a[i] * b[i];
        }
        return sum;
    }
}
