package org.auvsim.diagnosis.reading;

import org.auvsim.auvsml.document.DocumentException;
import org.auvsim.auvsml.run.ColumnMapping;
import org.auvsim.diagnosis.run.MeasuredRun;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/** Reads the run, or the runs between gaps, of one CSV file, in two passes. */
final class CsvRuns {
    /** Angles (rad) beyond this are suspicious, though a wheel may turn so far. */
    private static final double SEVERAL_TURNS = 20;

    private final Path file;
    private final String name;
    private final ColumnMapping mapping;
    private final MeasuredBody body;
    private final KnownOfRun known;
    private final List<String> notices = new ArrayList<>();

    CsvRuns(Path file, String name, ColumnMapping mapping, MeasuredBody body, KnownOfRun known) {
        this.file = file;
        this.name = name;
        this.mapping = mapping;
        this.body = body;
        this.known = known;
    }

    /**
     * The runs.
     *
     * @throws DocumentException naming row and column of what is wrong
     */
    List<MeasuredRun> read() throws DocumentException {
        Survey survey = survey();
        tell(survey);
        List<MeasuredRun> runs = runs(survey);
        if (survey.rows() < RunParts.FEWEST) {
            throw new DocumentException(
                    "%s: expected at least %d rows, but found %d; a shorter run tells nothing"
                            .formatted(file, RunParts.FEWEST, survey.rows()));
        }
        if (runs.isEmpty()) {
            throw new DocumentException(
                    "%s: no %d rows follow each other without a long gap%s; a shorter run tells nothing"
                            .formatted(
                                    file,
                                    RunParts.FEWEST,
                                    hasLimits() ? ", before a column is beyond its limit" : ""));
        }
        return runs;
    }

    private boolean hasLimits() {
        return mapping.column().stream().anyMatch(column -> column.runEnds().isPresent());
    }

    /** What was done to the data, and what looks wrong with it. */
    List<String> notices() {
        return notices;
    }

    private Survey survey() throws DocumentException {
        try (CsvTable table = CsvTable.open(file)) {
            Layout layout = new Layout(table, mapping, body.commands());
            body.undirected(layout.commands()).forEach(text -> notices.add(name + ": " + text));
            return Survey.of(table, layout);
        } catch (IOException e) {
            throw CsvTable.unreadable(file, e);
        }
    }

    private void tell(Survey survey) {
        if (survey.hasWholeSeconds()) {
            notices.add(
                    "%s: times are whole seconds with several rows each; read as a constant rate of %s Hz"
                            .formatted(name, Figures.shown(1 / survey.interval())));
        }
        if (survey.looksLikeMilliseconds()) {
            notices.add(
                    "%s: rows are %s s apart by whole numbers: are these milliseconds? If so, map '%s' with a scale of 0.001"
                            .formatted(name, Figures.shown(survey.interval()), Slots.TIME_NAME));
        }
    }

    private void tellAngles(double largest) {
        if (largest > SEVERAL_TURNS && !mapping.degrees()) {
            notices.add(
                    "%s: angles go up to %s rad: are they in degrees (--degrees)?"
                            .formatted(name, Figures.shown(largest)));
        }
    }

    private List<MeasuredRun> runs(Survey survey) throws DocumentException {
        try (CsvTable table = CsvTable.open(file)) {
            Layout layout = new Layout(table, mapping, body.commands());
            RowReader rows = new RowReader(table, layout, body.commands());
            RowSample samples =
                    new RowSample(
                            Axes.of(mapping.axes()),
                            layout.frame(Slots.U),
                            layout.frame(Slots.P),
                            body.usualOrientation(),
                            layout.lastingErrors());
            RunParts parts =
                    new RunParts(name, layout.commands(), samples, survey.extent(), known::tell);
            Clock clock = new Clock(survey);
            for (Optional<double[]> row = rows.next(); row.isPresent(); row = rows.next()) {
                if (rows.isOfAnotherRun()) {
                    clock.restart();
                    known.restart();
                    parts.restart();
                }
                double time = clock.next(row.get()[Slots.TIME]);
                rows.beyond().ifPresent(why -> parts.endBefore(time, why));
                parts.add(time, row.get(), true, rows.isToldOtherwise());
            }
            tellAngles(rows.largestAngle());
            List<MeasuredRun> runs = parts.runs();
            notices.addAll(parts.notices());
            return runs;
        } catch (IOException e) {
            throw CsvTable.unreadable(file, e);
        }
    }
}
