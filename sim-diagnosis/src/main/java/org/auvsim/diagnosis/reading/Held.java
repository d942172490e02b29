package org.auvsim.diagnosis.reading;

import org.apache.commons.math3.stat.StatUtils;
import org.auvsim.diagnosis.run.Channel;
import org.auvsim.diagnosis.run.MeasuredRun;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.stream.IntStream;

/**
 * Numbers that were written again in each row until their sensor told the next one, as a logger
 * writes the last fix of a receiver: measured in the first of these rows alone. All of them would
 * be taken for so many measurements of a body that jumps.
 */
final class Held {
    /** Fewer numbers that differ tell nothing. */
    private static final int FEWEST = 20;

    /** Numbers stay for as many rows as usual, give or take this share of them or one. */
    private static final double SPREAD = 0.25;

    /** This share of them does. */
    private static final double MOST = 0.9;

    /** What is rounded stays, too, but then changes by a step or two of its last digit. */
    private static final double STEPS = 5;

    /** Angles are the same if they differ by less (rad). */
    private static final double ROUNDING = 1e-9;

    private final Source source;
    private final MeasuredRun run;
    private final LeftOut again;
    private final Map<Integer, List<String>> columns = new TreeMap<>();

    private Held(Source source, MeasuredRun run) {
        this.source = source;
        this.run = run;
        this.again = new LeftOut(run);
    }

    /** Those of a run. */
    static LeftOut of(Source source, MeasuredRun run) {
        Held held = new Held(source, run);
        held.again.lookingAt(List.of(Channel.values()), held::find);
        held.columns.forEach(held::tell);
        return held.again;
    }

    private void tell(int rows, List<String> names) {
        again.tell(
                source.says(
                        names,
                        "each number stays the same for %d rows, then jumps to the next; taken as measured in the first of them, and not in the others"
                                .formatted(rows)));
    }

    private void find(Channel channel, int axis) {
        int[] samples = run.samples(channel, axis);
        double[] values = ToldNumbers.of(run, channel, axis);
        int[] firsts =
                IntStream.range(0, values.length)
                        .filter(i -> i == 0 || Math.abs(values[i] - values[i - 1]) > ROUNDING)
                        .toArray();
        int rows = usual(firsts);
        if (rows > 1 && jump(values, firsts)) {
            Set<Integer> fresh = new HashSet<>();
            Arrays.stream(firsts).forEach(fresh::add);
            for (int i = 0; i < samples.length; i++) {
                if (!fresh.contains(i)) {
                    again.add(channel, samples[i], axis);
                }
            }
            columns.computeIfAbsent(rows, _ -> new ArrayList<>())
                    .add(source.column(run, channel, axis));
        }
    }

    /** For how many rows a number stays, as nearly all do; 1 if they do not. */
    private static int usual(int[] firsts) {
        if (firsts.length < FEWEST) {
            return 1;
        }
        double[] rows =
                IntStream.range(1, firsts.length)
                        .mapToDouble(i -> firsts[i] - firsts[i - 1])
                        .toArray();
        double usual = Math.rint(StatUtils.percentile(rows, 50));
        double spread = Math.max(1, SPREAD * usual);
        long near = Arrays.stream(rows).filter(r -> Math.abs(r - usual) <= spread).count();
        return near < MOST * rows.length ? 1 : (int) usual;
    }

    /** Whether they change by far more than the least that they change by. */
    private static boolean jump(double[] values, int[] firsts) {
        double[] changes =
                IntStream.range(1, firsts.length)
                        .mapToDouble(i -> Math.abs(values[firsts[i]] - values[firsts[i - 1]]))
                        .toArray();
        return StatUtils.percentile(changes, 50) > STEPS * StatUtils.min(changes);
    }
}
