package org.auvsim.diagnosis.reading;

import org.auvsim.auvsml.document.DocumentException;
import org.auvsim.diagnosis.run.MeasuredRun;

import java.util.ArrayList;
import java.util.List;

/**
 * The part of each run that counts.
 *
 * @param from seconds after the run's first row, 0 or more
 * @param until likewise, later; infinite for the end
 */
record Stretch(double from, double until) {
    /** All of a run. */
    static final Stretch WHOLE = new Stretch(0, Double.POSITIVE_INFINITY);

    /** Times in files are rounded: a row that is earlier by less (s) is at the time. */
    private static final double ROUNDED = 1e-6;

    Stretch {
        if (!(from >= 0) || !(until > from)) {
            throw new IllegalArgumentException(
                    "a run is taken from %s s %s; expected 0 or more, and a later end"
                            .formatted(
                                    Figures.shown(from),
                                    Double.isInfinite(until)
                                            ? "after its first row to its end"
                                            : "until %s s after its first row"
                                                    .formatted(Figures.shown(until))));
        }
    }

    /**
     * Those parts of the runs of a file.
     *
     * @throws DocumentException if too little of a run is left
     */
    List<MeasuredRun> of(List<MeasuredRun> runs, List<Source> sources) throws DocumentException {
        if (equals(WHOLE)) {
            return runs;
        }
        List<MeasuredRun> stretches = new ArrayList<>();
        for (int i = 0; i < runs.size(); i++) {
            MeasuredRun run = runs.get(i);
            int first = before(run, from);
            int last = before(run, until + 2 * ROUNDED) - 1;
            if (last - first + 1 < MeasuredRun.FEWEST) {
                throw tooShort(run, sources.get(i), Math.max(0, last - first + 1));
            }
            stretches.add(run.stretch(first, last));
        }
        return stretches;
    }

    private DocumentException tooShort(MeasuredRun run, Source source, int rows) {
        String end =
                Double.isInfinite(until)
                        ? "to its end"
                        : "until %s s after it".formatted(Figures.shown(until));
        return new DocumentException(
                source.says(
                        "run '%s' has %d rows from %s s after its first row %s, of its %s s; expected %d at least: take more of it"
                                .formatted(
                                        run.name(),
                                        rows,
                                        Figures.shown(from),
                                        end,
                                        Figures.shown(run.duration()),
                                        MeasuredRun.FEWEST)));
    }

    /** How many rows are before a time (s) after the first. */
    private static int before(MeasuredRun run, double time) {
        int rows = 0;
        while (rows < run.size() && run.time(rows) - run.time(0) < time - ROUNDED) {
            rows++;
        }
        return rows;
    }
}
