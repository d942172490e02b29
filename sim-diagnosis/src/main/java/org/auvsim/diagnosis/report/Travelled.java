package org.auvsim.diagnosis.report;

import org.auvsim.diagnosis.result.ForceResidual;
import org.auvsim.diagnosis.run.MeasuredRun;
import org.auvsim.server.feedback.RigidMotion;

import java.util.List;

/** How long the path is up to each sample (m), by a simulated motion: it has no noise. */
final class Travelled {
    private final MeasuredRun run;
    private final double[] length;

    Travelled(MeasuredRun run, List<RigidMotion> motion) {
        this.run = run;
        length = new double[Math.min(run.size(), motion.size())];
        for (int k = 1; k < length.length; k++) {
            length[k] =
                    length[k - 1] + motion.get(k).position().distance(motion.get(k - 1).position());
        }
    }

    /** At the times of forces. */
    double[] at(List<ForceResidual> forces) {
        double[] at = new double[forces.size()];
        for (int i = 0; i < at.length; i++) {
            double time = forces.get(i).time();
            at[i] = between(run.sampleAt(time), time);
        }
        return at;
    }

    private double between(int k, double time) {
        if (k + 1 >= length.length) {
            return length.length == 0 ? Double.NaN : length[length.length - 1];
        }
        double share = (time - run.time(k)) / (run.time(k + 1) - run.time(k));
        return length[k] + Math.clamp(share, 0, 1) * (length[k + 1] - length[k]);
    }
}
