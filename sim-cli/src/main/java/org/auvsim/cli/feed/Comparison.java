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
     * The simulated object has come here; between two calls its way is taken as straight. Rows
     * before the first call are left out.
     */
    void reached(MeasuredLog.Row here) {
        while (next < rows.size() && rows.get(next).time() <= here.time() + MeasuredLog.SAME_TIME) {
            compare(rows.get(next), here);
            next++;
        }
        before = Optional.of(here);
    }

    private void compare(MeasuredLog.Row row, MeasuredLog.Row here) {
        if (Math.abs(row.time() - here.time()) <= MeasuredLog.SAME_TIME) {
            add(here.position().minus(row.position()));
        } else if (before.isPresent()) {
            Vec3 simulated = MeasuredLog.between(before.get(), here, row.time());
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
