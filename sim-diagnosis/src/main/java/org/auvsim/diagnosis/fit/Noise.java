package org.auvsim.diagnosis.fit;

import org.apache.commons.math3.stat.descriptive.rank.Median;
import org.apache.commons.math3.util.ResizableDoubleArray;
import org.auvsim.core.math.Quat;
import org.auvsim.core.math.Vec3;
import org.auvsim.diagnosis.run.Channel;
import org.auvsim.diagnosis.run.MeasuredRun;

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

    private final Map<Channel, Double> deviations;

    private Noise(Map<Channel, Double> deviations) {
        this.deviations = deviations;
    }

    /** The noise of runs that were measured with the same sensors. */
    static Noise of(List<MeasuredRun> runs) {
        Map<Channel, Double> deviations = new EnumMap<>(Channel.class);
        for (Channel channel : Channel.values()) {
            ResizableDoubleArray differences = new ResizableDoubleArray();
            ResizableDoubleArray changes = new ResizableDoubleArray();
            for (MeasuredRun run : runs) {
                for (int k = 1; run.measures(channel) && k < run.size(); k++) {
                    addChanges(run, channel, k, changes);
                }
                for (int k = 3; run.measures(channel) && k < run.size(); k++) {
                    if (channel == Channel.ORIENTATION) {
                        addTurns(run, k, differences);
                    } else {
                        addThirds(run, channel, k, differences);
                    }
                }
            }
            if (differences.getNumElements() > 0) {
                deviations.put(
                        channel,
                        Math.max(
                                deviation(differences.getElements()),
                                Resolution.deviation(changes.getElements())));
            }
        }
        return new Noise(deviations);
    }

    /** Standard deviation of a channel's numbers, in its unit. */
    double of(Channel channel) {
        return deviations.getOrDefault(channel, 1.0);
    }

    /** Those of all channels that were measured. */
    Map<Channel, Double> byChannel() {
        return deviations;
    }

    private static void addThirds(
            MeasuredRun run, Channel channel, int k, ResizableDoubleArray to) {
        for (int axis = 0; axis < 3; axis++) {
            double third =
                    run.value(channel, k, axis)
                            - 3 * run.value(channel, k - 1, axis)
                            + 3 * run.value(channel, k - 2, axis)
                            - run.value(channel, k - 3, axis);
            if (!Double.isNaN(third)) {
                to.addElement(Math.abs(third));
            }
        }
    }

    private static void addChanges(
            MeasuredRun run, Channel channel, int k, ResizableDoubleArray to) {
        Optional<Quat> before = run.orientation(k - 1);
        Optional<Quat> after = run.orientation(k);
        for (int axis = 0; axis < 3; axis++) {
            double change = run.value(channel, k, axis) - run.value(channel, k - 1, axis);
            boolean isMeasured = !Double.isNaN(change);
            if (isMeasured && channel == Channel.ORIENTATION) {
                change = Misses.axis(Misses.turn(before.orElseThrow(), after.orElseThrow()), axis);
                to.addElement(Math.abs(change) < ROUNDED ? 0 : change);
            } else if (isMeasured) {
                to.addElement(change);
            }
        }
    }

    private static void addTurns(MeasuredRun run, int k, ResizableDoubleArray to) {
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
                to.addElement(Math.abs(Misses.axis(second, axis)));
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
