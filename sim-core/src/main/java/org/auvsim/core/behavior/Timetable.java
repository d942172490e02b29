package org.auvsim.core.behavior;

import java.util.List;
import java.util.Optional;
import java.util.function.ToDoubleFunction;

/** Rows in order of time, of which the last one that has come holds. */
final class Timetable {
    /** A row counts from this much (s) before its time: sums of time steps round. */
    private static final double TOLERANCE = 1e-9;

    private Timetable() {}

    static <R> void requireOrder(String name, List<R> rows, ToDoubleFunction<R> at) {
        for (int i = 1; i < rows.size(); i++) {
            double before = at.applyAsDouble(rows.get(i - 1));
            double here = at.applyAsDouble(rows.get(i));
            if (!(here >= before)) {
                throw new IllegalArgumentException(
                        "rows of schedule '%s' must be in order of time, but %s s follows %s s"
                                .formatted(name, here, before));
            }
        }
    }

    /** The last row that is not after {@code time}, by bisection; empty before the first. */
    static <R> Optional<R> at(double time, List<R> rows, ToDoubleFunction<R> at) {
        int low = 0;
        int high = rows.size();
        while (low < high) {
            int middle = (low + high) >>> 1;
            if (at.applyAsDouble(rows.get(middle)) <= time + TOLERANCE) {
                low = middle + 1;
            } else {
                high = middle;
            }
        }
        return low == 0 ? Optional.empty() : Optional.of(rows.get(low - 1));
    }
}
