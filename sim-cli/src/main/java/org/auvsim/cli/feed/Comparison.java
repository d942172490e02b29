package org.auvsim.cli.feed;

import org.auvsim.core.math.Vec3;

import java.util.List;
import java.util.Optional;

/** How far a simulated path is from rows of a log that the simulator was not told. */
final class Comparison {
    private final List<MeasuredLog.Row> rows;
    private int next;
    private Optional<MeasuredLog.Row> before = Optional.empty();
    private int compared;
    private double sumOfSquares;
    private double largest;

    Comparison(List<MeasuredLog.Row> rows) {
        this.rows = rows;
    }

    /**
     * The simulated object has made a step. Within it, its way is taken as straight; rows before
     * the end of the first step are left out.
     *
     * @param arrival where the step brought it, before a correction of the position that came after
     *     the step: the way there must not know of that
     * @param departure where it went on from
     */
    void stepped(MeasuredLog.Row arrival, MeasuredLog.Row departure) {
        double end = departure.time();
        while (next < rows.size() && rows.get(next).time() <= end + MeasuredLog.SAME_TIME) {
            compare(rows.get(next), arrival, departure);
            next++;
        }
        before = Optional.of(departure);
    }

    private void compare(MeasuredLog.Row row, MeasuredLog.Row arrival, MeasuredLog.Row departure) {
        if (Math.abs(row.time() - departure.time()) <= MeasuredLog.SAME_TIME) {
            add(departure.position().minus(row.position()));
        } else if (before.isPresent()) {
            Vec3 simulated = MeasuredLog.between(before.get(), arrival, row.time());
            add(simulated.minus(row.position()));
        }
    }

    private void add(Vec3 error) {
        compared++;
        sumOfSquares += error.dot(error);
        largest = Math.max(largest, error.norm());
    }

    /** Rows compared so far. */
    int compared() {
        return compared;
    }

    /** Root of the mean square distance (m) at these rows. */
    double rms() {
        return Math.sqrt(sumOfSquares / compared);
    }

    /** Largest distance (m) at these rows. */
    double largest() {
        return largest;
    }
}
