package org.auvsim.cli.feed;

import org.auvsim.core.math.Vec3;

import java.util.ArrayList;
import java.util.List;

/**
 * Where something was, and when: at least one row, in order of time.
 *
 * @param row the rows, whose times (s) increase
 */
public record MeasuredLog(List<Row> row) {
    /** Times closer than this (s) are one: sums of time steps round. */
    static final double SAME_TIME = 1e-6;

    /** A position (m, world axes) at a time (s). */
    public record Row(double time, Vec3 position) {}

    /**
     * A checked log.
     *
     * @throws IllegalArgumentException if there is no row, or one is not after the one before
     */
    public MeasuredLog {
        row = List.copyOf(row);
        if (row.isEmpty()) {
            throw new IllegalArgumentException("a log needs a row");
        }
        for (int i = 1; i < row.size(); i++) {
            if (!(row.get(i).time() > row.get(i - 1).time())) {
                throw new IllegalArgumentException(
                        "times must increase, but %s s follows %s s"
                                .formatted(row.get(i).time(), row.get(i - 1).time()));
            }
        }
    }

    /** Time (s) of the first row. */
    double begin() {
        return row.getFirst().time();
    }

    /** Time (s) of the last row. */
    public double end() {
        return row.getLast().time();
    }

    /** How many rows have come at {@code time} (s). */
    int rowsUntil(double time) {
        int low = 0;
        int high = row.size();
        while (low < high) {
            int middle = (low + high) >>> 1;
            if (row.get(middle).time() <= time + SAME_TIME) {
                low = middle + 1;
            } else {
                high = middle;
            }
        }
        return low;
    }

    /** Where it was at a time (s) between begin and end, linear between two rows. */
    Vec3 positionAt(double time) {
        int next = rowsUntil(time);
        Row before = row.get(Math.max(next - 1, 0));
        if (next == 0 || next == row.size() || time - before.time() <= SAME_TIME) {
            return before.position();
        }
        Row after = row.get(next);
        return between(before, after, time);
    }

    /** On the straight line from one row to another. */
    static Vec3 between(Row before, Row after, double time) {
        double share = (time - before.time()) / (after.time() - before.time());
        Vec3 way = after.position().minus(before.position());
        return before.position().plus(way.times(share));
    }

    /** Each {@code n}-th row, or all others. */
    private List<Row> rows(int n, boolean nth) {
        List<Row> rows = new ArrayList<>();
        for (int i = 0; i < row.size(); i++) {
            boolean isNth = n > 0 && (i + 1) % n == 0;
            if (isNth == nth) {
                rows.add(row.get(i));
            }
        }
        return rows;
    }

    /** Each {@code n}-th row; none for 0. */
    List<Row> everyNth(int n) {
        return rows(n, true);
    }

    /** All rows but each {@code n}-th. */
    List<Row> allButEveryNth(int n) {
        return rows(n, false);
    }
}
