package org.auvsim.diagnosis.reading;

import org.auvsim.core.entity.Frame;
import org.auvsim.diagnosis.run.Channel;
import org.auvsim.diagnosis.run.MeasuredRun;
import org.auvsim.diagnosis.run.Reading;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.stream.IntStream;

/**
 * Numbers that are no possible motion: for a row or a few they are far from all others, and the
 * next one is among these again. They are marks of what was not measured (-9999), or faults of a
 * sensor or of what wrote the file. No model could follow them.
 */
final class Spikes {
    private static final int FEWEST = 20;

    /** So many rows in a row at most. */
    private static final int MOST_ROWS = 3;

    /** So many times the range of the middle half of all numbers they are beside it at least. */
    private static final double FAR = 30;

    /** Before and after it others are beside that by less. */
    private static final double NEAR = 2;

    private static final int AXES = 3;

    private final Source source;
    private final MeasuredRun run;
    private final Set<Reading> all = new HashSet<>();
    private final List<String> notices = new ArrayList<>();

    Spikes(Source source, MeasuredRun run) {
        this.source = source;
        this.run = run;
        for (Channel channel :
                List.of(Channel.POSITION, Channel.VELOCITY, Channel.ANGULAR_VELOCITY)) {
            for (int axis = 0; axis < AXES; axis++) {
                find(channel, axis);
            }
        }
    }

    /** The run without them; itself, if there are none. */
    MeasuredRun without() {
        return all.isEmpty() ? run : run.without(all);
    }

    /** What is told of them. */
    List<String> notices() {
        return notices;
    }

    private void find(Channel channel, int axis) {
        int[] samples =
                IntStream.range(0, run.size())
                        .filter(k -> !Double.isNaN(run.value(channel, k, axis)))
                        .toArray();
        if (samples.length < FEWEST) {
            return;
        }
        double[] values =
                Arrays.stream(samples).mapToDouble(k -> run.value(channel, k, axis)).toArray();
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
        int begin = 0;
        for (int i = 0; i < values.length; i++) {
            if (isBeside(values[i], low, high, FAR * range)) {
                continue;
            }
            boolean isBack =
                    begin > 0
                            && i - begin <= MOST_ROWS
                            && !isBeside(values[begin - 1], low, high, NEAR * range)
                            && !isBeside(values[i], low, high, NEAR * range);
            for (int far = begin; far < i; far++) {
                if (isBack) {
                    found.add(samples[far]);
                } else {
                    others.add(values[far]);
                }
            }
            others.add(values[i]);
            begin = i + 1;
        }
        for (int far = begin; far < values.length; far++) {
            others.add(values[far]);
        }
        if (!found.isEmpty()) {
            found.forEach(sample -> all.add(new Reading(channel, sample, axis)));
            tell(channel, axis, found, others);
        }
    }

    private static boolean isBeside(double value, double low, double high, double by) {
        return value < low - by || value > high + by;
    }

    private List<String> columns(Channel channel, int axis) {
        return channel != Channel.POSITION && run.frame(channel) == Frame.BODY
                ? source.columns(channel)
                : List.of(source.column(channel, axis));
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
        notices.add(
                source.says(
                        row(first),
                        columns(channel, axis),
                        "%s, which is no possible motion: all others lie between %s and %s; treated as not measured; if that is right, leave such cells empty"
                                .formatted(
                                        what,
                                        Figures.shown(Collections.min(others)),
                                        Figures.shown(Collections.max(others)))));
    }

    /** That of a sample, where each row is one; else the first. */
    private long row(int sample) {
        boolean isEachRow = source.last() - source.first() + 1 == run.size();
        return isEachRow ? source.first() + sample : source.first();
    }
}
