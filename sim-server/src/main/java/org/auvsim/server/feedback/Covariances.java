package org.auvsim.server.feedback;

import org.apache.commons.math3.linear.RealMatrix;

import java.util.Arrays;

/** What becomes of covariances. */
final class Covariances {
    private Covariances() {}

    /** M C M^T: the covariance of M x, if C is that of x; exactly symmetric. */
    static RealMatrix through(RealMatrix m, RealMatrix covariance) {
        RealMatrix carried = m.multiply(covariance).multiply(m.transpose());
        return carried.add(carried.transpose()).scalarMultiply(0.5);
    }

    static boolean isFinite(RealMatrix covariance) {
        return Arrays.stream(covariance.getData())
                .flatMapToDouble(Arrays::stream)
                .allMatch(Double::isFinite);
    }
}
