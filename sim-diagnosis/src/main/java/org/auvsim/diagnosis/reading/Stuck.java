package org.auvsim.diagnosis.reading;

import org.apache.commons.math3.stat.StatUtils;
import org.auvsim.diagnosis.run.Channel;
import org.auvsim.diagnosis.run.MeasuredRun;

import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.SortedSet;
import java.util.TreeSet;
import java.util.stream.IntStream;

/**
 * Numbers of a sensor that stopped, or of a logger that went on with its last one: the same in each
 * of many rows, to the last digit, though noise changes all others from row to row, and the body
 * moves, as others tell, or is elsewhere after them. They tell of no motion. Of what rests a sensor
 * may well tell the same.
 */
final class Stuck {
    private static final int AXES = 3;

    /** Angles are the same if they differ by less (rad): they were rotations meanwhile. */
    private static final double ROUNDING = 1e-9;

    /** What moves goes further than so many usual changes from row to row. */
    private static final double FAR = 10;

    private final Source source;
    private final MeasuredRun run;
    private final LeftOut stuck;

    /** Those that are the same from one sample to another, which are their key. */
    private final Map<List<Integer>, SortedSet<String>> columns = new LinkedHashMap<>();

    private Stuck(Source source, MeasuredRun run) {
        this.source = source;
        this.run = run;
        this.stuck = new LeftOut(run);
    }

    /** Those of a run. */
    static LeftOut of(Source source, MeasuredRun run) {
        Stuck of = new Stuck(source, run);
        of.stuck.lookingAt(List.of(Channel.values()), of::find);
        of.columns.forEach(of::tell);
        return of.stuck;
    }

    private void find(Channel channel, int axis) {
        int[] samples = run.samples(channel, axis);
        double[] values = values(channel, axis);
        boolean[] stays = new boolean[values.length];
        for (int from = 0; from < values.length; from = end(values, from)) {
            if (isLong(from, end(values, from))) {
                Arrays.fill(stays, from, end(values, from), true);
            }
        }
        double usual = UsualChange.of(values, stays);
        if (Double.isNaN(usual)) {
            return;
        }
        for (int from = 0; from < values.length; from = end(values, from)) {
            int end = end(values, from);
            boolean jumps =
                    end < values.length && Math.abs(values[end] - values[from]) > FAR * usual;
            if (isLong(from, end) && (jumps || othersMove(samples[from], samples[end - 1]))) {
                leaveOut(channel, axis, Arrays.copyOfRange(samples, from, end));
            }
        }
    }

    /** Whether any number that was measured from one sample to another tells of a motion. */
    private boolean othersMove(int first, int last) {
        return Arrays.stream(Channel.values())
                .anyMatch(
                        channel ->
                                IntStream.range(0, AXES)
                                        .anyMatch(axis -> moves(channel, axis, first, last)));
    }

    private boolean moves(Channel channel, int axis, int first, int last) {
        int[] samples = run.samples(channel, axis);
        double[] values = values(channel, axis);
        double[] changes =
                IntStream.range(1, values.length)
                        .mapToDouble(i -> Math.abs(values[i] - values[i - 1]))
                        .toArray();
        double[] meanwhile =
                IntStream.range(0, samples.length)
                        .filter(i -> first <= samples[i] && samples[i] <= last)
                        .mapToDouble(i -> values[i])
                        .toArray();
        return meanwhile.length > 0
                && StatUtils.max(meanwhile) - StatUtils.min(meanwhile)
                        > FAR * StatUtils.percentile(changes, 50);
    }

    /** Those of a column; angles go on beyond half a turn. */
    private double[] values(Channel channel, int axis) {
        double[] values = ToldNumbers.of(run, channel, axis);
        for (int i = 1; channel == Channel.ORIENTATION && i < values.length; i++) {
            double by = values[i] - values[i - 1];
            values[i] = values[i - 1] + Math.IEEEremainder(by, 2 * Math.PI);
        }
        return values;
    }

    /** Where numbers from one on are no longer the same. */
    private static int end(double[] values, int from) {
        int end = from + 1;
        while (end < values.length && Math.abs(values[end] - values[from]) <= ROUNDING) {
            end++;
        }
        return end;
    }

    private static boolean isLong(int from, int end) {
        return end - from > UsualChange.FEWEST;
    }

    /** The first of them was measured, it may be. */
    private void leaveOut(Channel channel, int axis, int[] samples) {
        for (int i = 1; i < samples.length; i++) {
            stuck.add(channel, samples[i], axis);
        }
        columns.computeIfAbsent(
                        List.of(samples[0], samples[samples.length - 1]), _ -> new TreeSet<>())
                .add(source.column(run, channel, axis));
    }

    private void tell(List<Integer> samples, SortedSet<String> names) {
        int first = samples.getFirst();
        stuck.tell(
                source.says(
                        source.row(first, run),
                        List.copyOf(names),
                        "to the last digit the same from %s to %s s, though noise changes it from row to row elsewhere, as if a sensor was stuck; treated as not measured there; if that is right, leave such cells empty"
                                .formatted(
                                        Figures.shown(run.time(first)),
                                        Figures.shown(run.time(samples.getLast())))));
    }
}
