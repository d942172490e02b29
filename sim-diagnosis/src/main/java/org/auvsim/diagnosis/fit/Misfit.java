package org.auvsim.diagnosis.fit;

import org.apache.commons.math3.complex.Complex;
import org.apache.commons.math3.transform.DftNormalization;
import org.apache.commons.math3.transform.FastFourierTransformer;
import org.apache.commons.math3.transform.TransformType;
import org.auvsim.diagnosis.result.Discrepancy;

import java.util.Arrays;
import java.util.OptionalDouble;

/** Describes what no cause explains: where it shows, when, and whether it has a frequency. */
final class Misfit {
    private static final String AXES = "xyz";

    /** A frequency stands out that has this share of all power. */
    private static final double STANDS_OUT = 0.3;

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
                double square = meanSquare(row(judged, r, row));
                if (square > worst) {
                    worst = square;
                    worstRun = r;
                    worstRow = row;
                }
            }
        }
        Misses of = judged.fit().data().get(worstRun);
        double[] misses = row(judged, worstRun, worstRow);
        int peak = 0;
        for (int k = 0; k < misses.length; k++) {
            if (Math.abs(misses[k]) > Math.abs(misses[peak])) {
                peak = k;
            }
        }
        Misses.Row row = of.rows().get(worstRow);
        return new Discrepancy(
                row.channel(),
                AXES.charAt(row.axis()),
                of.run().name(),
                of.run().time(peak),
                judged.fit().motions().get(worstRun)[peak].position(),
                frequency(misses, of.run().duration()),
                share);
    }

    private static double[] row(Judged judged, int run, int row) {
        int rows = judged.fit().data().get(run).rows().size();
        double[] all = judged.outcome().misses().get(run);
        double[] of = new double[all.length / rows];
        for (int k = 0; k < of.length; k++) {
            of[k] = all[k * rows + row];
        }
        return of;
    }

    private static double meanSquare(double[] values) {
        return Arrays.stream(values).map(v -> v * v).average().orElse(0);
    }

    /** The frequency (Hz) that has most of the power; samples are taken as evenly spaced. */
    static OptionalDouble frequency(double[] misses, double duration) {
        int size = Integer.highestOneBit(misses.length);
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
                size > 4
                        && peak > 1
                        && spectrum[peak].abs() * spectrum[peak].abs() > STANDS_OUT * sum;
        double used = duration * size / (misses.length - 1);
        return standsOut ? OptionalDouble.of(peak / used) : OptionalDouble.empty();
    }
}
