package org.auvsim.diagnosis.verdict;

import org.apache.commons.math3.complex.Complex;
import org.apache.commons.math3.transform.DftNormalization;
import org.apache.commons.math3.transform.FastFourierTransformer;
import org.apache.commons.math3.transform.TransformType;
import org.auvsim.diagnosis.fit.Judged;
import org.auvsim.diagnosis.residual.Misses;
import org.auvsim.diagnosis.result.Axis;
import org.auvsim.diagnosis.result.Discrepancy;

import java.util.Arrays;
import java.util.OptionalDouble;
import java.util.stream.IntStream;

/** Describes what no cause explains: where it shows, when, and whether it has a frequency. */
final class Misfit {
    /** A frequency stands out that has this share of all power. */
    private static final double STANDS_OUT = 0.3;

    /** Of fewer numbers any has. */
    private static final int FEWEST = 8;

    /** Numbers that are taken as evenly spaced may be off by this share of a swing. */
    private static final double MOST_TURNED = 0.125;

    private Misfit() {}

    /**
     * The largest of a fit.
     *
     * @param share that the fit explains
     */
    static Discrepancy largest(Judged judged, double share) {
        int worstRun = 0;
        int worstRow = 0;
        double worst = -1;
        for (int r = 0; r < judged.fit().data().size(); r++) {
            for (int row = 0; row < judged.fit().data().get(r).rows().size(); row++) {
                double square = meanSquare(numbers(judged, r, row));
                if (square > worst) {
                    worst = square;
                    worstRun = r;
                    worstRow = row;
                }
            }
        }
        Misses of = judged.fit().data().get(worstRun);
        int[] samples = samples(of, worstRow);
        double[] misses = numbers(judged, worstRun, worstRow);
        int peak = 0;
        for (int i = 0; i < misses.length; i++) {
            if (Math.abs(misses[i]) > Math.abs(misses[peak])) {
                peak = i;
            }
        }
        Misses.Row row = of.rows().get(worstRow);
        double[] times = Arrays.stream(samples).mapToDouble(of.run()::time).toArray();
        return new Discrepancy(
                row.channel(),
                Axis.of(of.run(), row.channel(), row.axis()),
                of.run().name(),
                times[peak],
                judged.fit().motions().get(worstRun)[samples[peak]].position(),
                frequency(misses, times),
                share);
    }

    /** Samples in which there is a number. */
    private static int[] samples(Misses of, int row) {
        int rows = of.rows().size();
        return IntStream.range(0, of.run().size())
                .filter(k -> of.isMeasured(k * rows + row))
                .toArray();
    }

    /** What is missed of the numbers that were measured; the others are missed by nothing. */
    private static double[] numbers(Judged judged, int run, int row) {
        Misses of = judged.fit().data().get(run);
        double[] all = judged.outcome().misses().get(run);
        return Arrays.stream(samples(of, row))
                .mapToDouble(k -> all[k * of.rows().size() + row])
                .toArray();
    }

    private static double meanSquare(double[] values) {
        return Arrays.stream(values).map(v -> v * v).average().orElse(0);
    }

    /**
     * The frequency (Hz) that has most of the power; none where times are so uneven that it would
     * be another one.
     */
    static OptionalDouble frequency(double[] misses, double[] times) {
        int size = Integer.highestOneBit(misses.length);
        if (size < FEWEST) {
            return OptionalDouble.empty();
        }
        double mean = Arrays.stream(misses, 0, size).average().orElse(0);
        double[] centred = Arrays.stream(misses, 0, size).map(v -> v - mean).toArray();
        Complex[] spectrum =
                new FastFourierTransformer(DftNormalization.STANDARD)
                        .transform(centred, TransformType.FORWARD);
        int peak = 1;
        double sum = 0;
        for (int i = 1; i < size / 2; i++) {
            double power = spectrum[i].abs() * spectrum[i].abs();
            sum += power;
            if (power > spectrum[peak].abs() * spectrum[peak].abs()) {
                peak = i;
            }
        }
        boolean standsOut =
                peak > 1 && spectrum[peak].abs() * spectrum[peak].abs() > STANDS_OUT * sum;
        double spacing = (times[size - 1] - times[0]) / (size - 1);
        double frequency = peak / (size * spacing);
        return standsOut && unevenness(times, size) * frequency < MOST_TURNED
                ? OptionalDouble.of(frequency)
                : OptionalDouble.empty();
    }

    /** How far the first times are at most from evenly spaced ones between the same ends (s). */
    private static double unevenness(double[] times, int size) {
        double spacing = (times[size - 1] - times[0]) / (size - 1);
        double most = 0;
        for (int i = 0; i < size; i++) {
            most = Math.max(most, Math.abs(times[i] - times[0] - i * spacing));
        }
        return most;
    }
}
