package org.auvsim.diagnosis.reading;

import org.auvsim.auvsml.document.DocumentException;
import org.auvsim.auvsml.document.DocumentKind;
import org.auvsim.auvsml.document.MissingFile;
import org.auvsim.auvsml.mapping.AuvsmlMapper;
import org.auvsim.auvsml.run.ColumnMapping;
import org.auvsim.auvsml.run.MeasuredAxes;
import org.auvsim.auvsml.run.Run;
import org.auvsim.auvsml.run.RunDifferences;
import org.auvsim.core.entity.Current;
import org.auvsim.core.entity.Field;
import org.auvsim.diagnosis.model.BelievedModel;
import org.auvsim.diagnosis.run.MeasuredRun;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.BiFunction;

/**
 * Reads measured runs of one body: CSV with a document beside it, or recordings with feedback. Long
 * files are read row by row; of more rows than a diagnosis needs, some are left out, with a notice.
 */
public final class RunReader {
    private static final String IN_NED =
            "runs are read in axes x north, y east, z down; all that is said of them, and the"
                    + " scenario, is in x east, y north, z up, of the body in forward, left, up";

    /** What looks for numbers that count as not measured, each in what the ones before leave. */
    private static final List<BiFunction<Source, MeasuredRun, LeftOut>> FAULTS =
            List.of(Held::of, Clipped::of, Stuck::of, Spikes::of);

    private final BelievedModel model;
    private final ColumnMapping mapping;
    private final AuvsmlMapper mapper;
    private final Documents documents;
    private final MeasuredBody body;
    private final Stretch stretch;

    /**
     * A reader of runs of the model's body.
     *
     * @param mapping how columns are to be read
     * @param mapper knows the effects and currents that documents may state
     */
    public RunReader(BelievedModel model, ColumnMapping mapping, AuvsmlMapper mapper) {
        this(model, mapping, mapper, Stretch.WHOLE);
    }

    private RunReader(
            BelievedModel model, ColumnMapping mapping, AuvsmlMapper mapper, Stretch stretch) {
        this.model = model;
        this.mapping = mapping;
        this.mapper = mapper;
        this.documents = new Documents(mapper);
        this.body = new MeasuredBody(model.variant().body());
        this.stretch = stretch;
    }

    /**
     * A reader that takes of each run only what is between two times (s) after its first row.
     *
     * @param until infinite for the end
     * @throws IllegalArgumentException unless 0 &lt;= from &lt; until
     */
    public RunReader between(double from, double until) {
        return new RunReader(model, mapping, mapper, new Stretch(from, until));
    }

    /** One that takes all of each run. */
    RunReader ofWholeRuns() {
        return new RunReader(model, mapping, mapper);
    }

    /** What is to be known of all runs, however many. */
    List<String> notices() {
        List<String> notices = new ArrayList<>();
        PossibleMass.notice(model).ifPresent(notices::add);
        if (mapping.axes() == MeasuredAxes.NED) {
            notices.add(IN_NED);
        }
        return notices;
    }

    /**
     * The mapping in a file.
     *
     * @throws DocumentException with a sentence for each fault and its place
     */
    public static ColumnMapping mapping(Path file, AuvsmlMapper mapper) throws DocumentException {
        return new Documents(mapper).read(ColumnMapping.class, file);
    }

    /**
     * What is in a file, under the file's name.
     *
     * @throws DocumentException naming file, row and column of what cannot be used
     */
    public RunFile read(Path file) throws DocumentException {
        requireRenamed(List.of(file));
        return read(file, nameOf(file));
    }

    /**
     * Refuses a mapping that renames a column which none of the files has.
     *
     * @throws DocumentException naming it, or a file that cannot be used
     */
    void requireRenamed(List<Path> files) throws DocumentException {
        Renames renames = new Renames(mapping);
        for (Path file : renames.isEmpty() ? List.<Path>of() : files) {
            if (kind(file) == DocumentKind.OTHER) {
                renames.in(file, columns(file));
            }
        }
        renames.require();
    }

    private static List<String> columns(Path file) throws DocumentException {
        try (CsvTable table = CsvTable.open(file)) {
            return table.columns();
        } catch (IOException e) {
            throw CsvTable.unreadable(file, e);
        }
    }

    /** The same under another name; what the file does not have is not renamed. */
    RunFile read(Path file, String name) throws DocumentException {
        return switch (kind(file)) {
            case RECORDING -> recorded(file, name);
            case SCENARIO ->
                    throw new DocumentException(
                            file + " is a scenario; expected a measured run, CSV or a recording");
            case OTHER -> csv(file, name);
        };
    }

    /** A file's name without its ending, in capitals or not. */
    static String nameOf(Path file) {
        return file.getFileName()
                .toString()
                .replaceFirst("(?i)(\\.csv|\\.auvsml|\\.auvsml\\.gz|\\.txt|\\.tsv)$", "");
    }

    private static DocumentKind kind(Path file) throws DocumentException {
        try {
            if (Files.exists(file) && !Files.isRegularFile(file) && !Files.isDirectory(file)) {
                throw new DocumentException(
                        file
                                + " is a pipe or a device, which can be read once only; expected a"
                                + " file, as runs are read twice: write it to one");
            }
            return DocumentKind.of(file);
        } catch (IOException e) {
            throw CsvTable.unreadable(file, e);
        }
    }

    private RunFile csv(Path file, String name) throws DocumentException {
        List<String> notices = new ArrayList<>();
        Run document = documentBeside(file, name, notices);
        CsvRuns csv = csv(file, name, document, mapping.axes());
        List<MeasuredRun> runs = csv.read();
        if (csv.milliseconds().isPresent()) {
            double step = model.scenario().timeStep().delta();
            csv.milliseconds().get().requireFewSteps(stretch.of(runs, csv.sources()), step);
        }
        notices.addAll(csv.notices());
        Optional<Suspicion> axes =
                new ModelAxes(model, mapping.axes())
                        .suspicion(runs, other -> csv(file, name, document, other).read())
                        .map(seen -> seen.of(file));
        return checked(
                file, runs, csv.sources(), document, notices, axes, csv.turns(), csv.doubt());
    }

    private CsvRuns csv(Path file, String name, Run document, MeasuredAxes axes) {
        KnownOfRun known = new KnownOfRun(document, mapping.start());
        return new CsvRuns(file, name, mapping.in(axes), body, known);
    }

    private RunFile checked(
            Path file,
            List<MeasuredRun> runs,
            List<Source> sources,
            Run document,
            List<String> notices,
            Optional<Suspicion> axes,
            Optional<Suspicion> ofAngles,
            Doubt before)
            throws DocumentException {
        List<Suspicion> suspicions = new ArrayList<>();
        ofAngles.ifPresent(suspicions::add);
        axes.ifPresent(suspicions::add);
        axes.map(Suspicion::notice).ifPresent(notices::add);
        List<String> doubts = new ArrayList<>();
        List<MeasuredRun> sound = new ArrayList<>();
        List<Suspicion> turns = new ArrayList<>();
        for (int i = 0; i < runs.size(); i++) {
            MeasuredRun run = runs.get(i);
            for (BiFunction<Source, MeasuredRun, LeftOut> faults : FAULTS) {
                LeftOut found = faults.apply(sources.get(i), run);
                notices.addAll(found.notices());
                run = found.without();
            }
            sound.add(run);
            Plausibility plausibility =
                    new Plausibility(model, sound.get(i), sources.get(i), mapping.degrees());
            doubts.addAll(plausibility.notices());
            plausibility.turns().ifPresent(turns::add);
        }
        doubts.addAll(new StatedPlausibility(beside(file), document, sound, sources).notices());
        notices.addAll(doubts);
        turns.forEach(each -> notices.add(each.notice()));
        Doubt ofTurns = turns.isEmpty() ? Doubt.NONE : Doubt.UNTIL_EXPLAINED;
        suspicions.addAll(turns);
        Map<String, String> settled = new LinkedHashMap<>();
        suspicions.forEach(each -> settled.put(each.notice(), each.settled()));
        Doubt ofData = doubts.isEmpty() ? Doubt.NONE : Doubt.LASTING;
        return new RunFile(
                file,
                stretch.of(sound, sources),
                sources,
                document.role(),
                notices,
                before.and(ofTurns).and(ofData),
                settled,
                axes.isPresent());
    }

    private RunFile recorded(Path file, String name) throws DocumentException {
        List<String> notices = new ArrayList<>();
        Run document = documentBeside(file, name, notices);
        KnownOfRun known = new KnownOfRun(document, mapping.start());
        RecordedRuns recorded = new RecordedRuns(file, name, body, mapper, known);
        List<MeasuredRun> runs = recorded.read();
        notices.addAll(recorded.notices());
        List<Source> sources = Collections.nCopies(runs.size(), Source.of(file));
        return checked(
                file,
                runs,
                sources,
                document,
                notices,
                Optional.empty(),
                Optional.empty(),
                recorded.doubt());
    }

    /** Where a document is that says something of a file's runs, if there is one. */
    private static Path beside(Path file) {
        return file.resolveSibling(nameOf(file) + ".xml");
    }

    /** What the XML file of the same name says; a scenario of that name is no such document. */
    private Run documentBeside(Path file, String name, List<String> notices)
            throws DocumentException {
        Path beside = beside(file);
        if (!Files.exists(beside)) {
            MissingFile.capitals(beside).forEach(other -> notices.add(notRead(other, beside)));
            return Run.NOTHING_KNOWN;
        }
        if (kind(beside) == DocumentKind.SCENARIO) {
            notices.add(
                    "%s: is a scenario, and says nothing of the run '%s' beside it"
                            .formatted(beside, name));
            return Run.NOTHING_KNOWN;
        }
        Run document = documents.read(Run.class, beside);
        for (RunDifferences own : document.differences().stream().toList()) {
            requireMass(own, beside);
            requireNew(own, beside);
        }
        return document;
    }

    private static String notRead(Path other, Path document) {
        return "%s: is not read: a document that says more of the run beside it would be named '%s'; rename it so if it is one"
                .formatted(other, document.getFileName());
    }

    private void requireMass(RunDifferences own, Path file) throws DocumentException {
        double mass = model.variant().body().mass().orElseThrow();
        if (!(mass + own.mass() > 0)) {
            throw new DocumentException(
                    "%s: differences: mass is %s kg, which leaves '%s' nothing of its %s kg; expected how many kg more, or less, it had than in the scenario"
                            .formatted(
                                    file,
                                    Figures.shown(own.mass()),
                                    model.body(),
                                    Figures.shown(mass)));
        }
    }

    private void requireNew(RunDifferences own, Path file) throws DocumentException {
        for (Current current : own.currents()) {
            for (Field<?> other : model.scenario().field()) {
                if (current.id() == other.id() || current.name().equals(other.name())) {
                    throw new DocumentException(
                            "%s: the current '%s' (id %d) has the id or the name of the scenario's '%s' (id %d); give it others"
                                    .formatted(
                                            file,
                                            current.name(),
                                            current.id(),
                                            other.name(),
                                            other.id()));
                }
            }
        }
    }
}
