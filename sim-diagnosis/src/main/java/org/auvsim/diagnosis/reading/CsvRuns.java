package org.auvsim.diagnosis.reading;

import org.auvsim.auvsml.document.DocumentException;
import org.auvsim.auvsml.run.ColumnMapping;
import org.auvsim.core.actuator.Fin;
import org.auvsim.core.actuator.Propulsor;
import org.auvsim.core.entity.Actuator;
import org.auvsim.diagnosis.run.Axes;
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
    private List<Source> sources = List.of();
    private Source longest;
    private Doubt doubt = Doubt.NONE;
    private Optional<Suspicion> turns = Optional.empty();
    private Optional<LikeMilliseconds> milliseconds = Optional.empty();

    CsvRuns(Path file, String name, ColumnMapping mapping, MeasuredBody body, KnownOfRun known) {
        this.file = file;
        this.name = name;
        this.mapping = mapping;
        this.body = body;
        this.known = known;
        this.longest = Source.of(file);
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
        if (survey.rows() < MeasuredRun.FEWEST) {
            throw new DocumentException(
                    "%s:%d: expected at least %d rows, but found %d; a shorter run tells nothing: give a longer one"
                            .formatted(file, survey.lastLine(), MeasuredRun.FEWEST, survey.rows()));
        }
        if (runs.isEmpty()) {
            throw new DocumentException(
                    longest.says(
                            "no %d rows follow each other without a long gap%s; a shorter run tells nothing: give a longer one"
                                    .formatted(
                                            MeasuredRun.FEWEST,
                                            hasLimits()
                                                    ? ", before a column is beyond its limit"
                                                    : "")));
        }
        return runs;
    }

    private boolean hasLimits() {
        return mapping.column().stream().anyMatch(column -> column.runEnds().isPresent());
    }

    /** Where each of the runs is. */
    List<Source> sources() {
        return sources;
    }

    /** What was done to the data, and what looks wrong with it. */
    List<String> notices() {
        return notices;
    }

    /** Whether some of that doubts that the numbers are what they are taken for. */
    Doubt doubt() {
        return doubt;
    }

    /** Angles that may be in degrees, if there are any. */
    Optional<Suspicion> turns() {
        return turns;
    }

    /** Times that look like milliseconds, if they do. */
    Optional<LikeMilliseconds> milliseconds() {
        return milliseconds;
    }

    private void doubt(Doubt kind, String notice) {
        notices.add(notice);
        doubt = doubt.and(kind);
    }

    private Survey survey() throws DocumentException {
        try (CsvTable table = CsvTable.open(file)) {
            Layout layout = new Layout(table, mapping, body.commands());
            List<Actuator> undirected = body.undirected(layout.commands());
            if (!undirected.isEmpty()) {
                notices.add(
                        undirected.size() == 1 ? lacks(undirected.getFirst()) : lacks(undirected));
            }
            doubt = doubt.and(body.isAllDrive(undirected) ? Doubt.LASTING : Doubt.NONE);
            return Survey.of(table, layout);
        } catch (IOException e) {
            throw CsvTable.unreadable(file, e);
        }
    }

    private String lacks(List<Actuator> several) {
        List<String> names = several.stream().map(Actuator::name).toList();
        return "%s:1: columns '%s': no column gives the commands of these actuators, so they keep the scenario's values; add the columns, or rename those that have them %s"
                .formatted(
                        file,
                        String.join("', '", names),
                        Remedy.renaming(Remedy.COLUMN, names.getFirst()));
    }

    private String lacks(Actuator actuator) {
        String expected =
                switch (actuator) {
                    case Propulsor _ -> "the level of the propulsor, -1 to 1";
                    case Fin _ -> "the angle of the fin";
                    default -> "what the actuator was told";
                };
        return "%s:1: column '%s': expected %s, but the header has no such column: it holds the scenario's %s; add the column, or rename the one that has it %s"
                .formatted(
                        file,
                        actuator.name(),
                        expected,
                        actuator.command(),
                        Remedy.renaming(Remedy.COLUMN, actuator.name()));
    }

    private void tell(Survey survey) {
        String time = survey.time().name();
        survey.afterMidnight()
                .ifPresent(
                        row ->
                                notices.add(
                                        "%s:%d: column '%s': times of day begin anew; they are read as going on past midnight, into the next day"
                                                .formatted(file, row, time)));
        if (survey.hasWholeSeconds()) {
            notices.add(
                    "%s: column '%s': times are whole seconds with several rows each; read as a constant rate of %s Hz"
                            .formatted(file, time, Figures.shown(1 / survey.interval())));
        }
        if (survey.looksLikeMilliseconds()) {
            LikeMilliseconds seen = new LikeMilliseconds(file, time, survey.interval());
            doubt(Doubt.LASTING, seen.notice());
            milliseconds = Optional.of(seen);
        }
    }

    private void tellAngles(RowReader rows, AnglesAndRates turning, Source whole) {
        Optional<String> wrong = turning.contradiction();
        wrong.ifPresent(what -> doubt(Doubt.LASTING, whole.says(turning.columns(whole), what)));
        if (wrong.isEmpty() && !turning.areRadians() && !mapping.degrees()) {
            turns = largeAngles(rows).or(() -> jumps(turning.jumping(whole), whole));
            turns.ifPresent(seen -> doubt(Doubt.UNTIL_EXPLAINED, seen.notice()));
        }
    }

    private Optional<Suspicion> largeAngles(RowReader rows) {
        return rows.largestAngle() > SEVERAL_TURNS
                ? Optional.of(
                        Suspicion.ofTurns(
                                "%s:%d: column '%s': angles go up to %s rad"
                                        .formatted(
                                                file,
                                                rows.angleRow(),
                                                rows.angleColumn(),
                                                Figures.shown(rows.largestAngle())),
                                "are they in degrees (--degrees, if all files are)? Of a heading"
                                        + " that counts its turns, take whole turns away"))
                : Optional.empty();
    }

    private static Optional<Suspicion> jumps(List<String> columns, Source whole) {
        return columns.isEmpty()
                ? Optional.empty()
                : Optional.of(
                        Suspicion.ofTurns(
                                whole.says(
                                        columns,
                                        "angles change by more than a quarter of a turn from row to"
                                                + " row"),
                                "are they in degrees (--degrees, if all files are)?"));
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
                            layout.ofAngles(),
                            body.usualOrientation(),
                            layout.lastingErrors());
            RunParts parts =
                    new RunParts(
                            name,
                            Source.of(file, layout, Axes.of(mapping.axes())),
                            layout.commands(),
                            samples,
                            survey.extent(),
                            known::tell);
            Clock clock = new Clock(survey);
            AnglesAndRates turning = new AnglesAndRates();
            for (Optional<double[]> row = rows.next(); row.isPresent(); row = rows.next()) {
                if (rows.isOfAnotherRun()) {
                    clock.restart();
                    turning.restart();
                    known.restart();
                    parts.restart();
                }
                parts.from(rows.line());
                double time = clock.next(row.get()[Slots.TIME]);
                turning.add(time, row.get());
                rows.beyond().ifPresent(why -> parts.endBefore(time, why));
                parts.add(time, row.get(), true, rows.isToldOtherwise());
            }
            tellAngles(rows, turning, Source.of(file, layout, Axes.of(mapping.axes())));
            List<MeasuredRun> runs = parts.runs();
            sources = parts.sources();
            longest = parts.longest();
            notices.addAll(parts.notices());
            return runs;
        } catch (IOException e) {
            throw CsvTable.unreadable(file, e);
        }
    }
}
