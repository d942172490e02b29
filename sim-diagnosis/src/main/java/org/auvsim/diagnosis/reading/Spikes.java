package org.auvsim.diagnosis.reading;

import org.auvsim.diagnosis.run.Channel;
import org.auvsim.diagnosis.run.MeasuredRun;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;

/**
 * Numbers that are no possible motion: for a row or a few they are far from the one before, and the
 * next one is near it again. They are marks of what was not measured (-9999), or faults of a sensor
 * or of what wrote the file. No model could follow them.
 */
final class Spikes {
    private static final int FEWEST = 20;

    /** So many rows in a row at most. */
    private static final int MOST_ROWS = 3;

    /** So many times the range of the middle half of all numbers they are off at least. */
    private static final double FAR = 30;

    /** By so much of it the next one may be off. */
    private static final double NEAR = 2;

    /** They jump by more than so many times what those before and after them go in a row. */
    private static final double QUICK = 10;

    private final Source source;
    private final MeasuredRun run;
    private final LeftOut all;

    private Spikes(Source source, MeasuredRun run) {
        this.source = source;
        this.run = run;
        this.all = new LeftOut(run);
    }

    /** Those of a run. */
    static LeftOut of(Source source, MeasuredRun run) {
        Spikes spikes = new Spikes(source, run);
        return spikes.all.lookingAt(
                List.of(Channel.POSITION, Channel.VELOCITY, Channel.ANGULAR_VELOCITY),
                spikes::find);
    }

    private void find(Channel channel, int axis) {
        int[] samples = run.samples(channel, axis);
        if (samples.length < FEWEST) {
            return;
        }
        double[] values = ToldNumbers.of(run, channel, axis);
        double[] sorted = values.clone();
        Arrays.sort(sorted);
        double low = sorted[sorted.length / 4];
        double high = sorted[sorted.length - 1 - sorted.length / 4];
        double range = high - low;
        if (range <= 0) {
            return;
        }
        List<Integer> found = new ArrayList<>();
        List<Double> others = new ArrayList<>();
        for (int i = 0; i < values.length; i++) {
            int back = back(values, i, others, low, high);
            for (; i < back; i++) {
                found.add(samples[i]);
            }
            if (i < values.length) {
                others.add(values[i]);
            }
        }
        if (!found.isEmpty()) {
            found.forEach(sample -> all.add(channel, sample, axis));
            tell(channel, axis, found, others);
        }
    }

    /**
     * Where numbers are back that are far off from one on: near the last before it; if there is
     * none, or none after it, they are far from where most are, too. The number itself if it is not
     * off, or none is back.
     */
    private static int back(
            double[] values, int from, List<Double> before, double low, double high) {
        double range = high - low;
        double last = before.isEmpty() ? Double.NaN : before.getLast();
        for (int back = from + 1; back <= from + MOST_ROWS && back <= values.length; back++) {
            double next = back < values.length ? values[back] : Double.NaN;
            boolean isEnd = Double.isNaN(last) || Double.isNaN(next);
            double jump = Double.POSITIVE_INFINITY;
            for (int i = from; i < back; i++) {
                boolean isFar = !isEnd || isBeside(values[i], low, high, FAR * range);
                double off = Math.min(distance(values[i], last), distance(values[i], next));
                jump = isFar ? Math.min(jump, off) : 0;
            }
            double away = isEnd ? 0 : Math.abs(next - last);
            double usual = Math.max(FAR * range, QUICK * usualStep(values, back, before));
            if (jump > usual && away <= Math.max(NEAR * range, jump / QUICK)) {
                return back;
            }
        }
        return from;
    }

    /** From a number, or none. */
    private static double distance(double value, double number) {
        return Double.isNaN(number) ? Double.POSITIVE_INFINITY : Math.abs(value - number);
    }

    /** How far numbers go from row to row, before and after: the shorter way. */
    private static double usualStep(double[] values, int back, List<Double> before) {
        int count = before.size();
        double until =
                count > 1
                        ? Math.abs(before.get(count - 1) - before.get(count - 2))
                        : Double.POSITIVE_INFINITY;
        double after =
                back + 1 < values.length
                        ? Math.abs(values[back + 1] - values[back])
                        : Double.POSITIVE_INFINITY;
        double step = Math.min(until, after);
        return Double.isInfinite(step) ? 0 : step;
    }

    private static boolean isBeside(double value, double low, double high, double by) {
        return value < low - by || value > high + by;
    }

    private void tell(Channel channel, int axis, List<Integer> found, List<Double> others) {
        int first = found.getFirst();
        String value = Figures.shown(run.value(channel, first, axis));
        String time = Figures.shown(run.time(first));
        String what =
                found.size() == 1
                        ? "at %s s it is %s".formatted(time, value)
                        : "%d readings are like the %s at %s s"
                                .formatted(found.size(), value, time);
        all.tell(
                source.says(
                        source.row(first, run),
                        List.of(source.column(run, channel, axis)),
                        "%s, which is no possible motion: all others lie between %s and %s; treated as not measured; if that is right, leave such cells empty"
                                .formatted(
                                        what,
                                        Figures.shown(Collections.min(others)),
                                        Figures.shown(Collections.max(others)))));
    }
}
