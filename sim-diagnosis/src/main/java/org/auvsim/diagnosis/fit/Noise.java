package org.auvsim.diagnosis.fit;

import org.apache.commons.math3.stat.descriptive.rank.Median;
import org.apache.commons.math3.util.ResizableDoubleArray;
import org.auvsim.core.math.Quat;
import org.auvsim.core.math.Vec3;
import org.auvsim.diagnosis.run.Channel;
import org.auvsim.diagnosis.run.MeasuredRun;

import java.util.Arrays;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/**
 * How much noise a measurement has, from the measurement alone: third differences of values, and
 * second differences of increments of rotation, hardly contain motion. Both have the variance of
 * the noise times 20 (1, 3, 3, 1 squared); the median absolute deviation is not misled by outliers.
 * A sensor that counts in steps has the noise of that at least.
 */
public final class Noise {
    /** Of a normal distribution: the median absolute deviation in standard deviations. */
    private static final double NORMAL = 0.6745;

    /** Numbers in a file are rounded: noise below this share of the largest cannot be told. */
    private static final double ROUNDED = 1e-9;

    /**
     * Axes whose noise differs by no more than this factor have the same: it is better known, and a
     * smooth motion leaves more along one than along another.
     */
    private static final double ALIKE = 4;

    /** By axis; NaN along or about an axis that tells nothing. */
    private final Map<Channel, double[]> deviations;

    private Noise(Map<Channel, double[]> deviations) {
        this.deviations = deviations;
    }

    /**
     * The noise of runs that were measured with the same sensors. What never changes in any of them
     * tells nothing, of noise or of motion: a body that is held there, or a sensor that has none.
     */
    static Noise of(List<MeasuredRun> runs) {
        Map<Channel, double[]> deviations = new EnumMap<>(Channel.class);
        for (Channel channel : Channel.values()) {
            Axis[] axes = {new Axis(), new Axis(), new Axis()};
            for (MeasuredRun run : runs) {
                Axis[] ofRun = axes(run, channel);
                for (int axis = 0; axis < 3; axis++) {
                    axes[axis].add(ofRun[axis]);
                }
            }
            List<Axis> telling = Arrays.stream(axes).filter(Axis::tells).toList();
            if (!telling.isEmpty()) {
                deviations.put(channel, deviations(axes, Axis.all(telling).deviation()));
            }
        }
        return new Noise(deviations);
    }

    /** What a run tells of each axis. */
    private static Axis[] axes(MeasuredRun run, Channel channel) {
        Axis[] axes = {new Axis(), new Axis(), new Axis()};
        for (int k = 1; run.measures(channel) && k < run.size(); k++) {
            addChanges(run, channel, k, axes);
        }
        for (int k = 3; run.measures(channel) && k < run.size(); k++) {
            if (channel == Channel.ORIENTATION) {
                addTurns(run, k, axes);
            } else {
                addThirds(run, channel, k, axes);
            }
        }
        return axes;
    }

    /** Whether numbers along or about an axis ever change in a run. */
    static boolean changes(MeasuredRun run, Channel channel, int axis) {
        return axes(run, channel)[axis].tells();
    }

    /** Of each axis its own, where they differ more than chance would have it. */
    private static double[] deviations(Axis[] axes, double common) {
        double[] own = Arrays.stream(axes).mapToDouble(Axis::deviation).toArray();
        double least = Double.POSITIVE_INFINITY;
        double most = 0;
        for (int axis = 0; axis < 3; axis++) {
            if (axes[axis].tells()) {
                least = Math.min(least, own[axis]);
                most = Math.max(most, own[axis]);
            }
        }
        boolean areAlike = most <= ALIKE * least;
        double[] deviations = new double[3];
        for (int axis = 0; axis < 3; axis++) {
            double deviation = areAlike ? common : own[axis];
            deviations[axis] = axes[axis].tells() ? deviation : Double.NaN;
        }
        return deviations;
    }

    /** Whether numbers along or about an axis ever change. */
    boolean tells(Channel channel, int axis) {
        return !Double.isNaN(of(channel, axis));
    }

    /** Standard deviation along or about an axis (0 to 2), in the channel's unit; or NaN. */
    double of(Channel channel, int axis) {
        return deviations.containsKey(channel) ? deviations.get(channel)[axis] : Double.NaN;
    }

    /** Standard deviation of a channel's numbers, all axes together, in its unit. */
    double of(Channel channel) {
        return deviations.containsKey(channel) ? rootMeanSquare(deviations.get(channel)) : 1;
    }

    /** Those of all channels that tell anything. */
    Map<Channel, Double> byChannel() {
        Map<Channel, Double> all = new EnumMap<>(Channel.class);
        deviations.keySet().forEach(channel -> all.put(channel, of(channel)));
        return all;
    }

    private static double rootMeanSquare(double[] ofAxes) {
        double sum = 0;
        int count = 0;
        for (double deviation : ofAxes) {
            if (!Double.isNaN(deviation)) {
                sum += deviation * deviation;
                count++;
            }
        }
        return Math.sqrt(sum / count);
    }

    /** What is known of the noise along or about an axis. */
    private static final class Axis {
        /** Sizes of differences that hardly contain motion. */
        private final ResizableDoubleArray differences = new ResizableDoubleArray();

        /** From one sample to the next. */
        private final ResizableDoubleArray changes = new ResizableDoubleArray();

        static Axis all(List<Axis> axes) {
            Axis all = new Axis();
            axes.forEach(all::add);
            return all;
        }

        /** With what another run, or another axis, tells; one that never changes tells nothing. */
        void add(Axis other) {
            if (other.tells()) {
                differences.addElements(other.differences.getElements());
                changes.addElements(other.changes.getElements());
            }
        }

        boolean tells() {
            return Arrays.stream(changes.getElements()).anyMatch(change -> change != 0);
        }

        double deviation() {
            if (differences.getNumElements() == 0) {
                return ROUNDED;
            }
            double noise = Noise.deviation(differences.getElements());
            return Math.max(noise, Resolution.deviation(changes.getElements()));
        }
    }

    private static void addThirds(MeasuredRun run, Channel channel, int k, Axis[] to) {
        for (int axis = 0; axis < 3; axis++) {
            double third =
                    run.value(channel, k, axis)
                            - 3 * run.value(channel, k - 1, axis)
                            + 3 * run.value(channel, k - 2, axis)
                            - run.value(channel, k - 3, axis);
            if (!Double.isNaN(third)) {
                to[axis].differences.addElement(Math.abs(third));
            }
        }
    }

    private static void addChanges(MeasuredRun run, Channel channel, int k, Axis[] to) {
        Optional<Quat> before = run.orientation(k - 1);
        Optional<Quat> after = run.orientation(k);
        for (int axis = 0; axis < 3; axis++) {
            double change = run.value(channel, k, axis) - run.value(channel, k - 1, axis);
            boolean isMeasured = !Double.isNaN(change);
            if (isMeasured && channel == Channel.ORIENTATION) {
                change = Misses.axis(Misses.turn(before.orElseThrow(), after.orElseThrow()), axis);
                to[axis].changes.addElement(Math.abs(change) < ROUNDED ? 0 : change);
            } else if (isMeasured) {
                to[axis].changes.addElement(change);
            }
        }
    }

    private static void addTurns(MeasuredRun run, int k, Axis[] to) {
        Vec3[] turns = new Vec3[3];
        for (int i = 0; i < 3; i++) {
            Optional<Quat> before = run.orientation(k - 3 + i);
            Optional<Quat> after = run.orientation(k - 2 + i);
            if (before.isEmpty() || after.isEmpty()) {
                return;
            }
            turns[i] = Misses.turn(before.get(), after.get());
        }
        Vec3 second = turns[2].minus(turns[1].times(2)).plus(turns[0]);
        for (int axis = 0; axis < 3; axis++) {
            if (!Double.isNaN(run.value(Channel.ORIENTATION, k, axis))) {
                to[axis].differences.addElement(Math.abs(Misses.axis(second, axis)));
            }
        }
    }

    private static double deviation(double[] sizes) {
        double largest = 0;
        for (double size : sizes) {
            largest = Math.max(largest, size);
        }
        double noise = new Median().evaluate(sizes) / NORMAL / Math.sqrt(20);
        return Math.max(noise, Math.max(ROUNDED, ROUNDED * largest));
    }
}
