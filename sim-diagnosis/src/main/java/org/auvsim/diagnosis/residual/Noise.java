package org.auvsim.diagnosis.residual;

import org.apache.commons.math3.util.ResizableDoubleArray;
import org.auvsim.auvsml.run.LastingError;
import org.auvsim.diagnosis.run.Channel;
import org.auvsim.diagnosis.run.MeasuredRun;

import java.util.Arrays;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.IntStream;

/**
 * How much noise a measurement has, from the measurement alone: third differences of the numbers
 * that were measured, and second differences of increments of rotation, hardly contain motion. Both
 * have the variance of the noise times 20 (1, 3, 3, 1 squared); the median absolute deviation is
 * not misled by outliers. A sensor that counts in steps has the noise of that at least. Of too few
 * numbers only those count whose standard deviations are stated.
 */
public final class Noise {
    /** Of fewer differences the median may be small by chance; without any, nothing is known. */
    private static final int FEWEST = 8;

    /** Numbers in a file are rounded: noise below this share of the largest cannot be told. */
    private static final double ROUNDED = 1e-9;

    /**
     * Axes whose noise differs by no more than chance would have it have the same, which is better
     * known. The logarithm of what the median tells of n such differences has a deviation of about
     * 1.6 / sqrt(n); three of them lie five of that apart at most.
     */
    private static final double SPREAD = 8;

    /** Of few differences chance would have any: axes that differ more have their own. */
    private static final double MOST_ALIKE = 4;

    /** By axis; NaN along or about an axis that tells nothing. */
    private final Map<Channel, double[]> deviations;

    /** What of it lasts from row to row. */
    private final Persistence persistence;

    private Noise(Map<Channel, double[]> deviations, Persistence persistence) {
        this.deviations = deviations;
        this.persistence = persistence;
    }

    /**
     * The noise of runs that were measured with the same sensors. What never changes in any of them
     * tells nothing, of noise or of motion: a body that is held there, or a sensor that has none.
     * So it is with numbers that are too few to tell their noise, which may be any. Where parts of
     * runs have too few, the runs that they are parts of may have enough.
     */
    public static Noise of(List<MeasuredRun> runs) {
        List<MeasuredRun> uncut = runs.stream().map(MeasuredRun::uncut).distinct().toList();
        Map<Channel, double[]> deviations = new EnumMap<>(Channel.class);
        for (Channel channel : Channel.values()) {
            Axis[] axes = axes(runs, channel);
            for (int axis = 0; axis < 3; axis++) {
                if (axes[axis].changes() && !axes[axis].areEnough()) {
                    axes[axis] = axes(uncut, channel)[axis];
                }
            }
            List<Axis> telling = Arrays.stream(axes).filter(Axis::tells).toList();
            if (!telling.isEmpty()) {
                deviations.put(channel, deviations(axes, Axis.all(telling).deviation()));
            }
        }
        return new Noise(deviations, Persistence.of(runs));
    }

    /** What runs tell of each axis, together. */
    private static Axis[] axes(List<MeasuredRun> runs, Channel channel) {
        Axis[] axes = {new Axis(), new Axis(), new Axis()};
        for (MeasuredRun run : runs) {
            Axis[] ofRun = axes(run, channel);
            for (int axis = 0; axis < 3; axis++) {
                axes[axis].add(ofRun[axis]);
            }
        }
        return axes;
    }

    /** What a run tells of each axis. */
    private static Axis[] axes(MeasuredRun run, Channel channel) {
        Axis[] axes = {new Axis(), new Axis(), new Axis()};
        for (int axis = 0; axis < 3; axis++) {
            Series series = Series.of(run, channel, axis);
            axes[axis].addStated(series);
            for (int i = 1; i < series.size(); i++) {
                axes[axis].changes.addElement(change(series, channel, i));
            }
            for (int i = 0; i + 3 < series.size(); i++) {
                axes[axis].differences.addElement(Math.abs(series.difference(i, 4)));
            }
        }
        return axes;
    }

    private static double change(Series series, Channel channel, int i) {
        double change = series.change(i);
        boolean isRounding = channel == Channel.ORIENTATION && Math.abs(change) < ROUNDED;
        return isRounding ? 0 : change;
    }

    /** Whether numbers along or about an axis ever change in a run. */
    public static boolean changes(MeasuredRun run, Channel channel, int axis) {
        return axes(run, channel)[axis].changes();
    }

    /** Of each axis its own, where they differ more than chance would have it. */
    private static double[] deviations(Axis[] axes, double common) {
        double[] own = Arrays.stream(axes).mapToDouble(Axis::deviation).toArray();
        double least = Double.POSITIVE_INFINITY;
        double most = 0;
        int fewest = Integer.MAX_VALUE;
        for (int axis = 0; axis < 3; axis++) {
            if (axes[axis].tells()) {
                least = Math.min(least, own[axis]);
                most = Math.max(most, own[axis]);
                fewest = Math.min(fewest, axes[axis].differences.getNumElements());
            }
        }
        double byChance = StrictMath.exp(SPREAD / Math.sqrt(fewest));
        boolean areAlike = most <= Math.min(byChance, MOST_ALIKE) * least;
        double[] deviations = new double[3];
        for (int axis = 0; axis < 3; axis++) {
            double deviation = areAlike ? common : own[axis];
            deviations[axis] = axes[axis].tells() ? deviation : Double.NaN;
        }
        return deviations;
    }

    /** Whether numbers along or about an axis ever change, and their noise is known. */
    public boolean tells(Channel channel, int axis) {
        return !Double.isNaN(of(channel, axis));
    }

    /** Standard deviation along or about an axis (0 to 2), in the channel's unit; or NaN. */
    public double of(Channel channel, int axis) {
        return deviations.containsKey(channel) ? deviations.get(channel)[axis] : Double.NaN;
    }

    /** The same of the part that is new in each row. */
    double anew(Channel channel, int axis) {
        return persistence
                .of(channel, axis)
                .map(Persistence.Lasting::anew)
                .orElse(of(channel, axis));
    }

    /** The part that lasts from row to row, though nothing is stated of it. */
    Optional<LastingError> lasting(Channel channel, int axis) {
        return persistence.of(channel, axis).map(Persistence.Lasting::error);
    }

    /** What is to be said of errors that last. */
    public Optional<String> notice() {
        return persistence.notice();
    }

    /**
     * Standard deviation of a channel's numbers, all axes and all that lasts together, in its unit.
     */
    public double of(Channel channel) {
        return deviations.containsKey(channel)
                ? rootMeanSquare(
                        IntStream.range(0, 3).mapToDouble(axis -> all(channel, axis)).toArray())
                : 1;
    }

    private double all(Channel channel, int axis) {
        return lasting(channel, axis)
                .map(error -> StrictMath.hypot(anew(channel, axis), error.deviation()))
                .orElse(of(channel, axis));
    }

    /** Those of all channels that tell anything. */
    public Map<Channel, Double> byChannel() {
        Map<Channel, Double> all = new EnumMap<>(Channel.class);
        deviations.keySet().forEach(channel -> all.put(channel, of(channel)));
        return all;
    }

    private static double rootMeanSquare(double[] all) {
        double sum = 0;
        int count = 0;
        for (double deviation : all) {
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

        /** Standard deviations that the data states. */
        private final ResizableDoubleArray stated = new ResizableDoubleArray();

        static Axis all(List<Axis> axes) {
            Axis all = new Axis();
            axes.forEach(all::add);
            return all;
        }

        /** With what another run, or another axis, tells; one that never changes tells nothing. */
        void add(Axis other) {
            if (other.changes()) {
                differences.addElements(other.differences.getElements());
                changes.addElements(other.changes.getElements());
                stated.addElements(other.stated.getElements());
            }
        }

        void addStated(Series series) {
            for (int i = 0; i < series.size(); i++) {
                double deviation = series.stated(i);
                if (!Double.isNaN(deviation)) {
                    stated.addElement(deviation);
                }
            }
        }

        boolean changes() {
            return Arrays.stream(changes.getElements()).anyMatch(change -> change != 0);
        }

        boolean tells() {
            return changes() && (areEnough() || stated.getNumElements() > 0);
        }

        private boolean areEnough() {
            return differences.getNumElements() >= FEWEST;
        }

        double deviation() {
            if (!areEnough()) {
                return rootMeanSquare(stated.getElements());
            }
            double noise = Noise.deviation(differences.getElements());
            return Math.max(noise, Resolution.deviation(changes.getElements()));
        }
    }

    private static double deviation(double[] sizes) {
        double largest = 0;
        for (double size : sizes) {
            largest = Math.max(largest, size);
        }
        double noise = MedianAbsoluteDeviation.standardDeviation(sizes) / Math.sqrt(20);
        return Math.max(noise, Math.max(ROUNDED, ROUNDED * largest));
    }
}
