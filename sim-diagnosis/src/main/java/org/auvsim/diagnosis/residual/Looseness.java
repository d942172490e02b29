package org.auvsim.diagnosis.residual;

import org.apache.commons.math3.stat.descriptive.rank.Percentile;
import org.apache.commons.math3.util.ResizableDoubleArray;
import org.auvsim.core.math.Quat;
import org.auvsim.diagnosis.run.Channel;
import org.auvsim.diagnosis.run.MeasuredRun;
import org.auvsim.diagnosis.run.OrientationError;
import org.auvsim.server.feedback.RigidMotion;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.stream.IntStream;

/**
 * How far the start of a window may be from a guess: as much as the whole run moves, no more. A
 * short window alone does not tell velocities from noise, and a model that is asked for motions
 * which the run never had, as fast spins, gets lost or stiff. Least of all may turns move that were
 * not measured: a window would tumble for a path that the model misses.
 */
public final class Looseness {
    private static final double SHARE_OF_RANGE = 0.1;
    private static final double NOISES = 10;

    /** Of an orientation (rad), and of a body's rates (m/s, rad/s) that nothing was measured of. */
    private static final double TURN = 0.3;

    private static final double UNKNOWN_SPEED = 10;
    private static final double UNKNOWN_RATE = 3;
    private static final double LEAST_SPEED = 0.01;
    private static final double LEAST_RATE = 0.1;

    /** What is not measured stays this much nearer to where the window before has led. */
    private static final double UNSEEN = 0.1;

    /** Rates are seen over this time (s), or longer where noise hides them. */
    private static final double WHILE = 0.4;

    /** The longest is this share of a run. */
    private static final double LONGEST_WHILE = 1.0 / 16;

    /**
     * So many percent of the rates are lower than what is taken for the largest, but for a factor.
     */
    private static final double MOST = 90;

    private static final double LARGER = 2;

    /** So many deviations the noise of two numbers together hardly exceeds along any axes. */
    private static final double NOISY = 2.5 * Math.sqrt(2);

    private Looseness() {}

    /** Standard deviations of a start, as {@link org.auvsim.diagnosis.run.KnownStart} has them. */
    public static List<Double> of(MeasuredRun run, Noise noise) {
        double place =
                SHARE_OF_RANGE * run.range(Channel.POSITION) + NOISES * noise.of(Channel.POSITION);
        double turn = TURN + NOISES * noise.of(Channel.ORIENTATION);
        double speed = rate(run, Channel.POSITION, noise, UNKNOWN_SPEED, LEAST_SPEED);
        double spin = rate(run, Channel.ORIENTATION, noise, UNKNOWN_RATE, LEAST_RATE);
        List<Double> deviations = new ArrayList<>();
        for (int i = 0; i < RigidMotion.SIZE; i++) {
            deviations.add(List.of(place, turn, speed, spin).get(i / 3));
        }
        return deviations;
    }

    /**
     * The same of a start to which another window has led.
     *
     * @param turns about which axes they were measured
     */
    public static List<Double> afterwards(
            MeasuredRun run, List<Double> looseness, boolean[] turns) {
        List<Double> deviations = new ArrayList<>(looseness);
        for (int axis = 0; axis < 3; axis++) {
            if (!turns[axis] && !run.measures(Channel.ANGULAR_VELOCITY)) {
                deviations.set(3 + axis, UNSEEN * looseness.get(3 + axis));
                deviations.set(9 + axis, UNSEEN * looseness.get(9 + axis));
            }
        }
        return deviations;
    }

    /** The rate that a channel hardly exceeds, without what noise adds to it. */
    private static double rate(
            MeasuredRun run, Channel channel, Noise noise, double unknown, double least) {
        double time = WHILE;
        double seen = seen(run, channel, time);
        double ofNoise = NOISY * noise.of(channel) / time;
        while (2 * ofNoise * ofNoise > seen * seen && 2 * time < LONGEST_WHILE * run.duration()) {
            time *= 2;
            seen = seen(run, channel, time);
            ofNoise = NOISY * noise.of(channel) / time;
        }
        if (Double.isNaN(seen)) {
            return unknown;
        }
        double own = Math.sqrt(Math.max(seen * seen / 2, seen * seen - ofNoise * ofNoise));
        return Math.max(least, LARGER * own);
    }

    /** The rate that a channel hardly exceeds, seen over a while; NaN if it has none. */
    private static double seen(MeasuredRun run, Channel channel, double time) {
        ResizableDoubleArray rates = new ResizableDoubleArray();
        Latest before = new Latest(run, channel);
        Latest now = new Latest(run, channel);
        for (int k = 0; k < run.size() && run.measures(channel); k++) {
            now.take(k);
            if (before.isMissing()) {
                before.take(k);
            } else if (now.isAfter(before, time)) {
                rates.addElement(now.rateSince(before));
                before.takeAll(now);
            }
        }
        return new Percentile(MOST).evaluate(rates.getElements());
    }

    /** The latest number of each axis of a channel, as they need not be measured together. */
    private static final class Latest {
        private static final int NEVER = -1;

        private final MeasuredRun run;
        private final Channel channel;

        /** The axes that are measured at all. */
        private final int[] measured;

        private final int[] samples = {NEVER, NEVER, NEVER};

        Latest(MeasuredRun run, Channel channel) {
            this.run = run;
            this.channel = channel;
            measured = IntStream.range(0, 3).filter(axis -> run.measures(channel, axis)).toArray();
        }

        void take(int k) {
            for (int axis = 0; axis < 3; axis++) {
                if (!Double.isNaN(run.value(channel, k, axis))) {
                    samples[axis] = k;
                }
            }
        }

        void takeAll(Latest other) {
            System.arraycopy(other.samples, 0, samples, 0, samples.length);
        }

        /** Whether an axis that is measured at all was not measured yet. */
        boolean isMissing() {
            return Arrays.stream(measured).anyMatch(axis -> samples[axis] == NEVER);
        }

        /** Whether each axis was measured a while later. */
        boolean isAfter(Latest before, double time) {
            return Arrays.stream(measured).allMatch(axis -> duration(before, axis) >= time);
        }

        private double duration(Latest before, int axis) {
            return run.time(samples[axis]) - run.time(before.samples[axis]);
        }

        double rateSince(Latest before) {
            if (channel == Channel.ORIENTATION) {
                int axis = Arrays.stream(measured).findFirst().orElseThrow();
                Quat from = run.orientation(before.samples[axis]).orElseThrow();
                Quat to = run.orientation(samples[axis]).orElseThrow();
                return OrientationError.turn(from, to).norm() / duration(before, axis);
            }
            double squares =
                    Arrays.stream(measured)
                            .mapToDouble(axis -> along(before, axis))
                            .map(v -> v * v)
                            .sum();
            return Math.sqrt(squares);
        }

        private double along(Latest before, int axis) {
            double way =
                    run.value(channel, samples[axis], axis)
                            - run.value(channel, before.samples[axis], axis);
            return way / duration(before, axis);
        }
    }

    /** The largest extent of a channel's numbers along an axis, in its unit. */
    public static double range(MeasuredRun run, Channel channel) {
        return run.range(channel);
    }
}
