package org.auvsim.diagnosis.verdict;

import org.auvsim.diagnosis.cause.Cause;
import org.auvsim.diagnosis.cause.Quantity;
import org.auvsim.diagnosis.fit.Hypothesis;
import org.auvsim.diagnosis.result.Numbers;
import org.auvsim.diagnosis.run.MeasuredRun;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/**
 * What was found to swing so slowly that runs show less than one period of it: they do not tell
 * that it comes again, and whatever grows or falls as slowly passes for a part of a swing.
 */
final class SlowSwing {
    /** A period is so many times as long as what was measured, at most. */
    private static final double MOST_PERIODS = 4;

    private SlowSwing() {}

    /** What is to be said of each cause that swings so. */
    static List<String> notices(List<MeasuredRun> runs, Hypothesis found) {
        double shown = shown(runs);
        List<String> notices = new ArrayList<>();
        periods(found)
                .forEach(
                        (cause, period) -> {
                            if (period > shown) {
                                notices.add(notice(cause, period, shown));
                            }
                        });
        return notices;
    }

    /**
     * Whether runs show less than a quarter of a period of one: that is a force or a current that
     * grows or falls, of which nobody knows why.
     */
    static boolean isTrend(List<MeasuredRun> runs, Hypothesis found) {
        double longest = MOST_PERIODS * shown(runs);
        return periods(found).values().stream().anyMatch(period -> period > longest);
    }

    /** Of each cause that swings (s). */
    private static Map<Cause, Double> periods(Hypothesis found) {
        Map<Cause, Double> periods = new LinkedHashMap<>();
        for (int c = 0; c < found.causes().size(); c++) {
            Cause cause = found.causes().get(c);
            cause.quantities(found.theta().get(c)).stream()
                    .filter(Quantity::isFrequency)
                    .forEach(of -> periods.put(cause, 2 * Math.PI / Math.abs(of.value())));
        }
        return periods;
    }

    private static String notice(Cause cause, double period, double shown) {
        return "the period of %s, %s s, is longer than the %s s that were measured: whatever grows or falls as slowly, as a leak does or a battery that runs down, looks like a part of a swing; longer runs tell whether it comes again"
                .formatted(cause.id(), Numbers.rounded(period), Numbers.rounded(shown));
    }

    /** From the first that was measured to the last (s), as all runs tell the same time. */
    private static double shown(List<MeasuredRun> runs) {
        double from = Double.POSITIVE_INFINITY;
        double to = Double.NEGATIVE_INFINITY;
        for (MeasuredRun run : runs) {
            MeasuredRun uncut = run.uncut();
            from = Math.min(from, uncut.time(0));
            to = Math.max(to, uncut.time(0) + uncut.duration());
        }
        return to - from;
    }
}
