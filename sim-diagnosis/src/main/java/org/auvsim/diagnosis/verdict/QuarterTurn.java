package org.auvsim.diagnosis.verdict;

import org.auvsim.diagnosis.cause.Cause;
import org.auvsim.diagnosis.fit.Hypothesis;
import org.auvsim.diagnosis.result.Numbers;

import java.util.Arrays;
import java.util.Optional;

/**
 * A sensor that was found to be turned by a quarter of a turn, or two: nobody mounts one so by
 * mistake, but columns of positions are swapped, or told in other axes.
 */
final class QuarterTurn {
    private static final String TURN = "axis_misalignment";

    /** The same turn, as it may be found (rad). */
    private static final double NEAR = 0.1;

    private QuarterTurn() {}

    /** What is to be said of it; empty if nothing was found to be turned so. */
    static Optional<String> notice(Hypothesis found) {
        for (int c = 0; c < found.causes().size(); c++) {
            Cause cause = found.causes().get(c);
            double angle = angle(found.theta().get(c));
            if (cause.id().equals(TURN) && isOfQuarters(angle)) {
                return Optional.of(words(angle));
            }
        }
        return Optional.empty();
    }

    private static double angle(double[] turn) {
        return Math.sqrt(Arrays.stream(turn).map(t -> t * t).sum());
    }

    private static boolean isOfQuarters(double angle) {
        double quarters = Math.rint(angle / (Math.PI / 2));
        return quarters > 0 && Math.abs(angle - quarters * Math.PI / 2) < NEAR;
    }

    private static String words(double angle) {
        return "the measured positions were found to be turned by %s rad, about %s: sensors are hardly mounted so, but columns may be swapped or in other axes, as north, east, down; if they are, map them (--mapping, --ned), and believe nothing else that was found before"
                .formatted(
                        Numbers.rounded(angle, 3),
                        angle < 0.75 * Math.PI ? "a quarter of a turn" : "half a turn");
    }
}
