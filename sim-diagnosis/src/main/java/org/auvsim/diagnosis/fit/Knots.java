package org.auvsim.diagnosis.fit;

import org.auvsim.core.math.Vec3;
import org.auvsim.diagnosis.model.Ensemble;
import org.auvsim.diagnosis.run.MeasuredRun;
import org.auvsim.server.feedback.RigidMotion;

import java.util.Arrays;

/**
 * Samples of a window that are so far apart as a model's steps are long. What parts two motions
 * changes slowly from one to the next: between them it runs along the cubic that has its numbers
 * and their rates at both (Hermite).
 */
final class Knots {
    private static final int HALF = RigidMotion.SIZE / 2;

    private final MeasuredRun run;
    private final int[] samples;

    private Knots(MeasuredRun run, int[] samples) {
        this.run = run;
        this.samples = samples;
    }

    /** From a window's first sample to that of the next, at most a step (s) apart if they can. */
    static Knots of(MeasuredRun run, Window window, double step) {
        int[] samples = new int[window.length() + 1];
        int count = 0;
        samples[count++] = window.from();
        for (int k = window.from() + 1; k <= window.to(); k++) {
            boolean isNextTooFar =
                    k == window.to()
                            || run.time(k + 1) - run.time(samples[count - 1]) > step * (1 + 1e-9);
            if (isNextTooFar) {
                samples[count++] = k;
            }
        }
        return new Knots(run, Arrays.copyOf(samples, count));
    }

    /** Their samples, in order. */
    int[] samples() {
        return samples.clone();
    }

    /** What of a motion at each sample of the window is at the knots. */
    RigidMotion[] of(RigidMotion[] motion) {
        RigidMotion[] at = new RigidMotion[samples.length];
        for (int q = 0; q < samples.length; q++) {
            at[q] = motion[samples[q] - samples[0]];
        }
        return at;
    }

    /**
     * A motion that parts from a given one as one rough motion parts from another.
     *
     * @param motion at each sample of the window
     * @param rough at each knot
     * @param other alike
     * @return at each sample of the window; lost if one of them is
     */
    RigidMotion[] parted(RigidMotion[] motion, RigidMotion[] rough, RigidMotion[] other) {
        RigidMotion[] parted = new RigidMotion[motion.length];
        if (isLost(motion) || isLost(rough) || isLost(other)) {
            Arrays.fill(parted, Ensemble.LOST);
            return parted;
        }
        double[] begin = other[0].minus(rough[0]);
        parted[0] = motion[0].plus(begin);
        for (int q = 1; q < samples.length; q++) {
            double[] end = other[q].minus(rough[q]);
            double[] beginRates = rates(begin, rough[q - 1]);
            double[] endRates = rates(end, rough[q]);
            double from = run.time(samples[q - 1]);
            double duration = run.time(samples[q]) - from;
            for (int k = samples[q - 1] + 1; k < samples[q]; k++) {
                double share = (run.time(k) - from) / duration;
                int at = k - samples[0];
                parted[at] =
                        motion[at].plus(between(begin, beginRates, end, endRates, duration, share));
            }
            parted[samples[q] - samples[0]] = motion[samples[q] - samples[0]].plus(end);
            begin = end;
        }
        return parted;
    }

    /** What gets lost is not known from its beginning on. */
    private static boolean isLost(RigidMotion[] motion) {
        return motion[0].equals(Ensemble.LOST);
    }

    /** How fast a small way and a small turn from a motion grow: a turn is carried along, too. */
    private static double[] rates(double[] parting, RigidMotion from) {
        Vec3 turn = new Vec3(parting[3], parting[4], parting[5]);
        Vec3 carried = from.angularVelocity().cross(turn);
        return new double[] {
            parting[6],
            parting[7],
            parting[8],
            parting[9] + carried.x(),
            parting[10] + carried.y(),
            parting[11] + carried.z()
        };
    }

    /** Ways and turns along the cubic; velocities change evenly. */
    private static double[] between(
            double[] begin,
            double[] beginRates,
            double[] end,
            double[] endRates,
            double duration,
            double s) {
        double[] between = new double[RigidMotion.SIZE];
        for (int i = 0; i < HALF; i++) {
            double slopes = s * (1 - s) * (1 - s) * beginRates[i] - s * s * (1 - s) * endRates[i];
            between[i] = begin[i] + s * s * (3 - 2 * s) * (end[i] - begin[i]) + duration * slopes;
        }
        for (int i = HALF; i < RigidMotion.SIZE; i++) {
            between[i] = (1 - s) * begin[i] + s * end[i];
        }
        return between;
    }
}
