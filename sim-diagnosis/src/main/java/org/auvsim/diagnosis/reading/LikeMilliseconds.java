package org.auvsim.diagnosis.reading;

import org.auvsim.auvsml.document.DocumentException;
import org.auvsim.diagnosis.run.MeasuredRun;

import java.nio.file.Path;
import java.util.List;

/**
 * Times of a file that look like milliseconds. Taken for seconds they are 1000 times as long, and
 * so is a search, which then comes to no end that anybody waits for.
 *
 * @param column that has them
 * @param interval between rows (s)
 */
record LikeMilliseconds(Path file, String column, double interval) {
    /** A search simulates runs some thousand times: in more steps of the model it takes hours. */
    private static final double MOST_STEPS = 100_000;

    /** What is suspected, of data that can be used nevertheless. */
    String notice() {
        return "%s: are these milliseconds? If so, map '%s' with a scale of 0.001 (--mapping)"
                .formatted(seen(), column);
    }

    /**
     * Refuses runs whose times would take too many steps.
     *
     * @param step of the model (s)
     * @throws DocumentException naming the column, and how to say which unit it has
     */
    void requireFewSteps(List<MeasuredRun> runs, double step) throws DocumentException {
        double seconds = runs.stream().mapToDouble(MeasuredRun::duration).sum();
        if (seconds / step > MOST_STEPS) {
            throw new DocumentException(
                    "%s, %s s in all, and a search in %s time steps of %s s would take hours: map '%s' with a scale of 0.001 if these are milliseconds, or of 1 if they are seconds (--mapping)"
                            .formatted(
                                    seen(),
                                    Figures.shown(seconds, 6),
                                    Figures.shown(seconds / step, 3),
                                    Figures.shown(step),
                                    column));
        }
    }

    private String seen() {
        return "%s:2: column '%s': rows are %s s apart by whole numbers"
                .formatted(file, column, Figures.shown(interval));
    }
}
