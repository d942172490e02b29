package org.auvsim.diagnosis.shooting;

import org.auvsim.core.math.Vec3;
import org.auvsim.diagnosis.model.Ensemble;
import org.auvsim.diagnosis.run.MeasuredRun;
import org.auvsim.server.feedback.RigidMotion;

import java.util.Arrays;
import java.util.function.IntPredicate;

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
        return of(run, window, step, k -> false);
    }

    /** The same, and at each sample at which a command or a scheduled force changes. */
    static Knots atEachCommand(MeasuredRun run, Window window, double step) {
        return of(run, window, step, k -> changesAt(run, k));
    }

    private static Knots of(MeasuredRun run, Window window, double step, IntPredicate isKnot) {
        int[] samples = new int[window.length() + 1];
        int count = 0;
        samples[count++] = window.from();
        for (int k = window.from() + 1; k <= window.to(); k++) {
            boolean isNextTooFar =
                    k == window.to()
                            || isKnot.test(k)
                            || run.time(k + 1) - run.time(samples[count - 1]) > step * (1 + 1e-9);
            if (isNextTooFar) {
                samples[count++] = k;
            }
        }
        return new Knots(run, Arrays.copyOf(samples, count));
    }

    /** Also where a scheduled force begins or ends between it and one of its neighbours. */
    private static boolean changesAt(MeasuredRun run, int sample) {
        double from = run.time(sample - 1);
        double to = run.time(Math.min(sample + 1, run.size() - 1));
        return run.commands().stream().anyMatch(command -> command.changesAt(sample))
                || run.forces().stream()
                        .anyMatch(f -> isIn(f.from(), from, to) || isIn(f.until(), from, to));
    }

    private static boolean isIn(double time, double from, double to) {
        return from <= time && time <= to;
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
     * A motion at each sample of the window: ways and turns along the cubics that have what they
     * are and their rates at both knots, velocities as these change.
     *
     * @param motion at each knot
     */
    RigidMotion[] filled(RigidMotion[] motion) {
        RigidMotion[] filled = new RigidMotion[samples[samples.length - 1] - samples[0] + 1];
        if (isLost(motion)) {
            Arrays.fill(filled, Ensemble.LOST);
            return filled;
        }
        filled[0] = motion[0];
        for (int q = 1; q < samples.length; q++) {
            double from = run.time(samples[q - 1]);
            double duration = run.time(samples[q]) - from;
            Arc arc = Arc.between(motion[q - 1], motion[q], duration);
            for (int k = samples[q - 1] + 1; k < samples[q]; k++) {
                filled[k - samples[0]] = arc.at((run.time(k) - from) / duration);
            }
            filled[samples[q] - samples[0]] = motion[q];
        }
        return filled;
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
