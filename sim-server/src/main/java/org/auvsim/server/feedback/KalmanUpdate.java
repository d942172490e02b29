package org.auvsim.server.feedback;

import org.apache.commons.math3.linear.ArrayRealVector;
import org.apache.commons.math3.linear.MatrixUtils;
import org.apache.commons.math3.linear.RealMatrix;
import org.auvsim.core.math.Cholesky;

import java.util.List;
import java.util.stream.IntStream;

/**
 * One measurement in an extended Kalman filter on the error of a rigid body's motion.
 *
 * @param motion the estimate with it
 * @param covariance of that estimate's error
 * @param surprise the innovation squared, in units of its covariance
 */
record KalmanUpdate(RigidMotion motion, RealMatrix covariance, double surprise) {
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
    static KalmanUpdate of(
            RigidMotion model, RealMatrix predicted, Target measured, RealMatrix noise) {
        RealMatrix pick = pick(measured);
        double[] innovation = pick.operate(measured.replacing(model).minus(model));
        RealMatrix carried = predicted.multiply(pick.transpose());
        Cholesky size = factor(pick.multiply(carried).add(noise));
        RealMatrix gain = gain(carried, size);
        RealMatrix left =
                MatrixUtils.createRealIdentityMatrix(RigidMotion.SIZE)
                        .subtract(gain.multiply(pick));
        return new KalmanUpdate(
                model.plus(gain.operate(innovation)),
                Covariances.through(left, predicted).add(Covariances.through(gain, noise)),
                new ArrayRealVector(innovation)
                        .dotProduct(new ArrayRealVector(size.solve(innovation))));
    }

    private static Cholesky factor(RealMatrix expected) {
        try {
            return new Cholesky(expected.getData());
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
    static RealMatrix measured(Target target, RealMatrix covariance) {
        return Covariances.through(pick(target), covariance);
    }

    /** P H^T S^-1, by the factor of S. */
    private static RealMatrix gain(RealMatrix carried, Cholesky size) {
        RealMatrix gain = carried.copy();
        for (int i = 0; i < gain.getRowDimension(); i++) {
            gain.setRow(i, size.solve(carried.getRow(i)));
        }
        return gain;
    }

    /** H: ones where a row belongs to a number of the motion's error that was measured. */
    private static RealMatrix pick(Target target) {
        List<Boolean> there =
                List.of(
                        target.position().isPresent(),
                        target.orientation().isPresent(),
                        target.velocity().isPresent(),
                        target.angularVelocity().isPresent());
        int[] all = IntStream.range(0, RigidMotion.SIZE).toArray();
        int[] measured = IntStream.of(all).filter(i -> there.get(i / 3)).toArray();
        return MatrixUtils.createRealIdentityMatrix(RigidMotion.SIZE).getSubMatrix(measured, all);
    }
}
