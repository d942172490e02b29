package org.auvsim.diagnosis.verdict;

import org.auvsim.diagnosis.fit.Judged;
import org.auvsim.diagnosis.residual.MedianAbsoluteDeviation;
import org.auvsim.diagnosis.residual.Misses;
import org.auvsim.diagnosis.residual.Noise;
import org.auvsim.diagnosis.result.Axis;
import org.auvsim.diagnosis.result.Numbers;
import org.auvsim.diagnosis.run.MeasuredRun;
import org.auvsim.server.feedback.RigidMotion;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.DoubleStream;

/**
 * Tells of runs whose numbers have much more noise than those of the others, though one noise is
 * taken for all: by third differences of what is missed, which hardly contain motion or misfit, and
 * their median absolute deviation, which outliers do not mislead.
 */
final class NoisierRuns {
    /** So many times the noise of the others is worth a word. */
    private static final double MUCH = 2;

    /** What has less than this share of the noise that is taken for all has not too much of it. */
    private static final double MOST = 0.8;

    /** Such a share of the standard deviation may be chance: four standard errors. */
    private static final double CERTAIN = 4;

    /**
     * The standard error of the deviation of n numbers, as a share of it, times the root of n: 1.17
     * of a median absolute deviation, and half as much again as successive differences share
     * numbers.
     */
    private static final double SPREAD = 1.75;

    /** The variance of third differences of noise: 1, 3, 3 and 1 squared. */
    private static final double VARIANCE = 20;

    /** By row: of each run that states no deviations the sizes of differences, in its unit. */
    private final Map<Misses.Row, Map<MeasuredRun, double[]>> differences = new LinkedHashMap<>();

    private final Noise noise;

    /** Of fitted runs, held-out ones beside them, for all of which one noise was taken. */
    NoisierRuns(Noise noise, Judged... fits) {
        this.noise = noise;
        for (Judged of : fits) {
            List<RigidMotion[]> motions = of.fit().motions();
            for (int r = 0; r < motions.size(); r++) {
                Misses data = of.fit().data().get(r);
                add(
                        data,
                        data.plain(
                                motions.get(r),
                                of.fit().variant().sensing(),
                                0,
                                data.run().size()));
            }
        }
    }

    private void add(Misses data, double[] plain) {
        MeasuredRun run = data.run();
        int width = data.rows().size();
        for (int r = 0; r < width; r++) {
            Misses.Row row = data.rows().get(r);
            List<Double> errors = new ArrayList<>();
            for (int k = 0; k < run.size(); k++) {
                boolean isStated = !Double.isNaN(run.deviation(row.channel(), k, row.axis()));
                if (data.isMeasured(k * width + r) && !isStated) {
                    errors.add(data.error(k * width + r, plain[k * width + r]));
                }
            }
            double[] third = new double[Math.max(0, errors.size() - 3)];
            for (int i = 0; i < third.length; i++) {
                third[i] =
                        Math.abs(
                                errors.get(i)
                                        - 3 * errors.get(i + 1)
                                        + 3 * errors.get(i + 2)
                                        - errors.get(i + 3));
            }
            differences
                    .computeIfAbsent(row, _ -> new LinkedHashMap<>())
                    .merge(run.uncut(), third, NoisierRuns::joined);
        }
    }

    private static double[] joined(double[] some, double[] more) {
        return DoubleStream.concat(Arrays.stream(some), Arrays.stream(more)).toArray();
    }

    /** A line for each axis of a run that is noisier than all others together. */
    List<String> notices() {
        List<String> notices = new ArrayList<>();
        differences.forEach(
                (row, runs) ->
                        runs.forEach(
                                (run, own) -> {
                                    double[] others =
                                            runs.entrySet().stream()
                                                    .filter(e -> !e.getKey().equals(run))
                                                    .flatMapToDouble(
                                                            e -> Arrays.stream(e.getValue()))
                                                    .toArray();
                                    if (isNoisier(own, others) && counts(row, own)) {
                                        notices.add(notice(run, row, own, others));
                                    }
                                }));
        return notices;
    }

    private static boolean isNoisier(double[] own, double[] others) {
        double ratio = deviation(own) / deviation(others);
        double chance = SPREAD * Math.sqrt(1.0 / own.length + 1.0 / others.length);
        return ratio >= MUCH
                && ratio < Double.POSITIVE_INFINITY
                && StrictMath.log(ratio) > CERTAIN * chance;
    }

    /** What counts in coarse steps has hardly any differences: its noise is that of the steps. */
    private boolean counts(Misses.Row row, double[] own) {
        return deviation(own) > MOST * noise.of(row.channel(), row.axis());
    }

    private static double deviation(double[] sizes) {
        return MedianAbsoluteDeviation.standardDeviation(sizes) / Math.sqrt(VARIANCE);
    }

    private static String notice(MeasuredRun run, Misses.Row row, double[] own, double[] others) {
        String unit = " " + row.channel().unit();
        return "%s: %s has %s times the noise of the other runs (%s against %s), but one noise is taken for all: state the standard deviations in all runs (as sd_x)"
                .formatted(
                        run.name(),
                        Axis.of(run, row.channel(), row.axis()).brief(row.channel()),
                        Numbers.rounded(deviation(own) / deviation(others)),
                        Numbers.rounded(deviation(own)) + unit,
                        Numbers.rounded(deviation(others)) + unit);
    }
}
