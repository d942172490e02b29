package org.auvsim.diagnosis.fit;

import org.auvsim.diagnosis.run.MeasuredRun;
import org.auvsim.server.feedback.RigidMotion;

/**
 * How exactly runs were measured, which weighs their residuals.
 *
 * @param position standard deviation of a coordinate (m)
 * @param rotation standard deviation of a rotation vector's component (rad)
 */
record Weights(double position, double rotation) {
    /** Rows of a sample: three of position, three of orientation. */
    static final int ROWS = 6;

    /**
     * Writes what a simulated motion misses of a sample, in standard deviations; 0 for what was not
     * measured.
     */
    void residuals(MeasuredRun.Sample sample, RigidMotion simulated, double[] to, int row) {
        RigidMotion measured =
                new RigidMotion(
                        sample.position().orElse(simulated.position()),
                        sample.orientation().orElse(simulated.orientation()),
                        simulated.velocity(),
                        simulated.angularVelocity());
        double[] difference = simulated.minus(measured);
        for (int i = 0; i < 3; i++) {
            to[row + i] = difference[i] / position;
            to[row + 3 + i] = difference[3 + i] / rotation;
        }
    }
}
