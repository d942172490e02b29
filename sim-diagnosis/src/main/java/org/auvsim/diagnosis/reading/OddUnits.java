package org.auvsim.diagnosis.reading;

import org.apache.commons.math3.stat.StatUtils;
import org.auvsim.auvsml.document.DocumentException;
import org.auvsim.diagnosis.run.Channel;
import org.auvsim.diagnosis.run.MeasuredRun;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.stream.IntStream;

/**
 * That one file of several is not in another unit than the others: its sensors would have a
 * thousand times the noise of theirs, and the body would go a thousand times as fast. A search
 * could only take that for something about the body.
 */
final class OddUnits {
    private static final int AXES = 3;

    /** Other files at least: of two nobody knows which is odd. */
    private static final int FEWEST_OTHERS = 2;

    /** Fewer numbers tell no noise. */
    private static final int FEWEST = 20;

    /** The noise of others differs by less than this factor. */
    private static final double ALIKE = 10;

    /** About a thousand times as large. */
    private static final Range THOUSAND = new Range(300, 3000);

    /** The same of what a body does otherwise in each run. */
    private static final Range ABOUT_THOUSAND = new Range(100, 10_000);

    /** About 57 times; less where angles go around. */
    private static final Range DEGREES = new Range(15, 200);

    private record Range(double from, double to) {
        boolean has(double ratio) {
            return from <= ratio && ratio <= to;
        }
    }

    private final List<RunFile> files;

    private OddUnits(List<RunFile> files) {
        this.files = files;
    }

    /**
     * Refuses a file that is in another unit than all others.
     *
     * @throws DocumentException naming its columns, how large they are, and what to do
     */
    static void require(List<RunFile> files) throws DocumentException {
        OddUnits units = new OddUnits(files);
        for (RunFile file : files) {
            units.requireLengths(file);
            units.requireAngles(file);
        }
    }

    private void requireLengths(RunFile file) throws DocumentException {
        List<Double> noises = ratios(file, Channel.POSITION, OddUnits::noise);
        List<Double> ways = ratios(file, Channel.POSITION, OddUnits::change);
        boolean isOdd =
                !noises.isEmpty()
                        && noises.stream().allMatch(THOUSAND::has)
                        && ways.stream().allMatch(ABOUT_THOUSAND::has);
        if (isOdd) {
            throw odd(
                    file,
                    Channel.POSITION,
                    "1000 times those of the other files, noise and all: are they in mm, or the"
                            + " others in km? If so, name the columns for their unit (x_mm)");
        }
    }

    /** A worse sensor has more noise, too: only angles that are in doubt by themselves count. */
    private void requireAngles(RunFile file) throws DocumentException {
        List<Double> noises = ratios(file, Channel.ORIENTATION, OddUnits::noise);
        boolean isAloneDoubted =
                file.doubt() != Doubt.NONE
                        && files.stream().allMatch(f -> f.equals(file) || f.doubt() == Doubt.NONE);
        if (isAloneDoubted && noises.size() > 1 && noises.stream().allMatch(DEGREES::has)) {
            throw odd(
                    file,
                    Channel.ORIENTATION,
                    "angles of several turns, with far more noise than those of the other files:"
                        + " are they in degrees? If so, name the columns for their unit (yaw_deg)");
        }
    }

    private static DocumentException odd(RunFile file, Channel channel, String sentence) {
        Source source = file.sources().getFirst();
        return new DocumentException(
                source.says(
                        source.columns(channel),
                        sentence + "; if they are right, diagnose this run by itself"));
    }

    /** A size of numbers of a run along or about an axis. */
    private interface Size {
        OptionalDouble of(MeasuredRun run, Channel channel, int axis);
    }

    /**
     * How many times the size of all others is that of a file, by axis; none if the others differ,
     * or are too few.
     */
    private List<Double> ratios(RunFile file, Channel channel, Size size) {
        List<Double> ratios = new ArrayList<>();
        for (int axis = 0; axis < AXES; axis++) {
            Optional<Double> own = size(file, channel, axis, size);
            int about = axis;
            List<Double> others =
                    files.stream()
                            .filter(f -> !f.equals(file))
                            .flatMap(f -> size(f, channel, about, size).stream())
                            .sorted()
                            .toList();
            if (own.isPresent() && others.size() >= FEWEST_OTHERS) {
                boolean areAlike = others.getLast() < ALIKE * others.getFirst();
                ratios.add(areAlike ? own.get() / others.get(others.size() / 2) : Double.NaN);
            }
        }
        return ratios;
    }

    /** That of its runs, the middle one. */
    private static Optional<Double> size(RunFile file, Channel channel, int axis, Size size) {
        double[] sizes =
                file.runs().stream()
                        .flatMapToDouble(run -> size.of(run, channel, axis).stream())
                        .filter(of -> of > 0)
                        .toArray();
        return sizes.length == 0 ? Optional.empty() : Optional.of(StatUtils.percentile(sizes, 50));
    }

    /** Third differences are mostly noise. */
    private static OptionalDouble noise(MeasuredRun run, Channel channel, int axis) {
        double[] v = ToldNumbers.of(run, channel, axis);
        return v.length < FEWEST
                ? OptionalDouble.empty()
                : middle(
                        IntStream.range(3, v.length)
                                .mapToDouble(i -> v[i] - 3 * v[i - 1] + 3 * v[i - 2] - v[i - 3])
                                .toArray());
    }

    /** By how much numbers change in a tenth of a run. */
    private static OptionalDouble change(MeasuredRun run, Channel channel, int axis) {
        double[] v = ToldNumbers.of(run, channel, axis);
        int tenth = v.length / 10;
        return v.length < FEWEST
                ? OptionalDouble.empty()
                : middle(
                        IntStream.range(tenth, v.length)
                                .mapToDouble(i -> v[i] - v[i - tenth])
                                .toArray());
    }

    private static OptionalDouble middle(double[] differences) {
        return OptionalDouble.of(
                StatUtils.percentile(Arrays.stream(differences).map(Math::abs).toArray(), 50));
    }
}
