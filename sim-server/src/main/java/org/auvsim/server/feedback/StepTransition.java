package org.auvsim.server.feedback;

import org.apache.commons.math3.linear.MatrixUtils;
import org.apache.commons.math3.linear.RealMatrix;

import java.util.Optional;

/**
 * How a step carries an error of an object's motion on, and what noise it adds: from covariance P
 * to F P F^T + Q.
 *
 * @param transition F, 12 x 12
 * @param noise Q, 12 x 12
 */
record StepTransition(RealMatrix transition, RealMatrix noise) {
    /** By how much a motion is changed to see what becomes of it (m, rad, m/s, rad/s). */
    private static final double DIFFERENCE = 1e-4;

    /** What is more than this comes of a jump, as at a collision that one try meets alone. */
    private static final double MOST = 1e3;

    /**
     * Of a step, by central differences through the step itself.
     *
     * @param noise what the step adds
     */
    static StepTransition of(Correction correction, RealMatrix noise) {
        RealMatrix transition = zero();
        for (int j = 0; j < RigidMotion.SIZE; j++) {
            transition.setColumn(j, column(correction, j));
        }
        return new StepTransition(transition, noise);
    }

    private static RealMatrix zero() {
        return MatrixUtils.createRealMatrix(RigidMotion.SIZE, RigidMotion.SIZE);
    }

    private static double[] column(Correction correction, int j) {
        Optional<RigidMotion> more = tried(correction, j, DIFFERENCE);
        Optional<RigidMotion> less = tried(correction, j, -DIFFERENCE);
        if (more.isEmpty() || less.isEmpty()) {
            return free(correction.duration(), j);
        }
        double[] column = more.get().minus(less.get());
        for (int i = 0; i < column.length; i++) {
            column[i] /= 2 * DIFFERENCE;
            if (!(Math.abs(column[i]) <= MOST)) {
                return free(correction.duration(), j);
            }
        }
        return column;
    }

    private static Optional<RigidMotion> tried(Correction correction, int j, double change) {
        double[] error = new double[RigidMotion.SIZE];
        error[j] = change;
        return correction.steppedFrom(correction.start().plus(error));
    }

    /** What becomes of an error of a body that nothing acts on. */
    private static double[] free(double duration, int j) {
        double[] column = new double[RigidMotion.SIZE];
        column[j] = 1;
        if (j >= 6) {
            column[j - 6] = duration;
        }
        return column;
    }

    /**
     * What white accelerations add within a time: of each axis q [t^3/3, t^2/2; t^2/2, t] for
     * position and velocity (Bar-Shalom, Li &amp; Kirubarajan 2001, section 6.2.2).
     *
     * @param duration t (s)
     * @param acceleration square root of their spectral density q (m/s^2 / sqrt(Hz))
     * @param angularAcceleration likewise of turns (rad/s^2 / sqrt(Hz))
     */
    static RealMatrix noise(double duration, double acceleration, double angularAcceleration) {
        RealMatrix noise = zero();
        double t = duration;
        for (int i = 0; i < 6; i++) {
            double density = i < 3 ? acceleration : angularAcceleration;
            double q = density * density;
            noise.setEntry(i, i, q * t * t * t / 3);
            noise.setEntry(i, i + 6, q * t * t / 2);
            noise.setEntry(i + 6, i, q * t * t / 2);
            noise.setEntry(i + 6, i + 6, q * t);
        }
        return noise;
    }

    /** That of {@code steps} such steps in a row, by squaring. */
    StepTransition repeated(long steps) {
        StepTransition all =
                new StepTransition(MatrixUtils.createRealIdentityMatrix(RigidMotion.SIZE), zero());
        StepTransition power = this;
        for (long left = steps; left > 0; left /= 2) {
            if (left % 2 == 1) {
                all = all.then(power);
            }
            power = power.then(power);
        }
        return all;
    }

    private StepTransition then(StepTransition next) {
        return new StepTransition(next.transition.multiply(transition), next.carry(noise));
    }

    /** What becomes of a covariance. */
    RealMatrix carry(RealMatrix covariance) {
        return Covariances.through(transition, covariance).add(noise);
    }
}
