package org.auvsim.diagnosis.verdict;

import org.auvsim.diagnosis.run.Channel;

import java.util.EnumMap;
import java.util.Map;
import java.util.OptionalDouble;

/** Errors of predictions by channel and by how far ahead, added up. */
final class HorizonErrors {
    private final int horizons;
    private final Map<Channel, double[]> squares = new EnumMap<>(Channel.class);
    private final Map<Channel, int[]> counts = new EnumMap<>(Channel.class);

    /** None yet, of so many horizons. */
    HorizonErrors(int horizons) {
        this.horizons = horizons;
    }

    /** Adds an error of one number, in the channel's unit; NaN of a model that got lost. */
    void add(Channel channel, int horizon, double error) {
        double square = Double.isNaN(error) ? Double.POSITIVE_INFINITY : error * error;
        squares.computeIfAbsent(channel, _ -> new double[horizons])[horizon] += square;
        counts.computeIfAbsent(channel, _ -> new int[horizons])[horizon]++;
    }

    /** These and others. */
    HorizonErrors plus(HorizonErrors others) {
        HorizonErrors sum = new HorizonErrors(horizons);
        sum.add(this);
        sum.add(others);
        return sum;
    }

    private void add(HorizonErrors others) {
        others.squares.forEach(
                (channel, of) -> {
                    double[] sums = squares.computeIfAbsent(channel, _ -> new double[horizons]);
                    for (int h = 0; h < horizons; h++) {
                        sums[h] += of[h];
                    }
                });
        others.counts.forEach(
                (channel, of) -> {
                    int[] sums = counts.computeIfAbsent(channel, _ -> new int[horizons]);
                    for (int h = 0; h < horizons; h++) {
                        sums[h] += of[h];
                    }
                });
    }

    /**
     * Root mean square of a channel's numbers at a horizon, infinite if a model got lost before;
     * empty if none was measured then.
     */
    OptionalDouble of(Channel channel, int horizon) {
        double[] sums = squares.get(channel);
        int[] numbers = counts.get(channel);
        return sums == null || numbers == null || numbers[horizon] == 0
                ? OptionalDouble.empty()
                : OptionalDouble.of(Math.sqrt(sums[horizon] / numbers[horizon]));
    }
}
