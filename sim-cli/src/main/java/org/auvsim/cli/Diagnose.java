package org.auvsim.cli;

import org.auvsim.auvsml.document.DocumentException;
import org.auvsim.auvsml.document.MissingFile;
import org.auvsim.auvsml.document.Scenario;
import org.auvsim.auvsml.mapping.AuvsmlMapper;
import org.auvsim.auvsml.mapping.ContextClasses;
import org.auvsim.cli.diagnose.Account;
import org.auvsim.cli.diagnose.ProgressBar;
import org.auvsim.cli.report.FileTrouble;
import org.auvsim.cli.report.UserError;
import org.auvsim.core.entity.WorldObjectDefinition;
import org.auvsim.diagnosis.Investigation;
import org.auvsim.diagnosis.Method;
import org.auvsim.diagnosis.cause.Cause;
import org.auvsim.diagnosis.cause.Library;
import org.auvsim.diagnosis.model.BelievedModel;
import org.auvsim.diagnosis.reading.Doubt;
import org.auvsim.diagnosis.reading.RunFiles;
import org.auvsim.diagnosis.reading.RunReader;
import org.auvsim.diagnosis.report.Report;
import org.auvsim.diagnosis.result.Diagnosis;
import org.auvsim.diagnosis.result.Verdict;
import org.auvsim.diagnosis.shaking.SoundRuns;

import picocli.CommandLine.Command;
import picocli.CommandLine.ExitCode;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Spec;

import java.io.IOException;
import java.io.PrintWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.Callable;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/** {@code auvsim diagnose}. */
@Command(
        name = "diagnose",
        description = {
            "Shows what a scenario gets wrong of measured runs, names the cause, writes the"
                    + " scenario with it, and measures what that gains on runs that were held out.",
            "Runs are CSV with a header (t in s; x, y, z in m; docs/measured-runs.md has the rest),"
                    + " or recordings with feedback."
        },
        footer = {
            "",
            "Ends with 0 for any verdict, 2 for input that cannot be used; with"
                    + " --fail-on-discrepancy with 1 unless the verdict is that nothing is wrong.",
            "Ctrl-C ends the search early; what it has found is reported, if judging it takes no"
                    + " more than 60 s, and the command ends with 130, whatever the verdict. Ctrl-C"
                    + " once more ends it at once, without a report.",
            "",
            "Example: auvsim diagnose --scenario examples/diagnosis/model.xml --fit"
                    + " examples/diagnosis/run1.csv examples/diagnosis/run2.csv --holdout"
                    + " examples/diagnosis/run3.csv --out report"
        })
final class Diagnose implements Callable<Integer> {
    /** What --fail-on-discrepancy ends with if something is wrong. */
    static final int DISCREPANCY = 1;

    /** Of so many objects that can move the names are told. */
    private static final int MOST_NAMES = 6;

    /** So long after Ctrl-C the best so far must have been judged. */
    private static final Duration PATIENCE = Duration.ofSeconds(60);

    @Spec private CommandSpec spec;

    @Option(
            names = "--scenario",
            required = true,
            paramLabel = "FILE",
            description = "The model as it is believed.")
    private Path scenarioFile = Path.of("");

    @Option(
            names = "--fit",
            required = true,
            arity = "1..*",
            paramLabel = "RUN",
            description = "Measured runs in which the cause is looked for.")
    private List<Path> fit = new ArrayList<>();

    @Option(
            names = "--holdout",
            arity = "1..*",
            paramLabel = "RUN",
            description =
                    "Measured runs that only judge; by default a third of the runs, or of the time"
                            + " of the only one.")
    private List<Path> heldOut = new ArrayList<>();

    @Option(
            names = "--reference",
            arity = "1..*",
            paramLabel = "RUN",
            description =
                    "Measured runs that are known to be sound: they tell how much the body shakes"
                            + " normally, where the mapping names columns for that.")
    private List<Path> reference = new ArrayList<>();

    @Option(
            names = "--out",
            paramLabel = "FOLDER",
            defaultValue = "auvsim-diagnosis",
            description =
                    "Where report.html, diagnosis.json and extended-scenario.xml go (default:"
                            + " ${DEFAULT-VALUE}).")
    private Path folder = Path.of("auvsim-diagnosis");

    @Option(
            names = "--body",
            paramLabel = "NAME",
            description = "The world object that was measured, if several can move.")
    private Optional<String> body = Optional.empty();

    @Option(
            names = "--from",
            paramLabel = "SECONDS",
            defaultValue = "0",
            description =
                    "Leaves out what is earlier than so long after each run's first row (default:"
                            + " ${DEFAULT-VALUE}).")
    private double from;

    @Option(
            names = "--until",
            paramLabel = "SECONDS",
            description = "Leaves out what is later than so long after each run's first row.")
    private double until = Double.POSITIVE_INFINITY;

    @Option(
            names = "--parts",
            paramLabel = "SECONDS",
            description =
                    "Cuts the runs to fit into parts of about that length, each with a start of its"
                            + " own: for long runs of unstable vehicles, and models that are only"
                            + " nearly right.")
    private Optional<Double> parts = Optional.empty();

    @Mixin private final RunFormat format = new RunFormat();

    @Option(
            names = "--causes",
            split = ",",
            paramLabel = "ID",
            description =
                    "Looks for these causes only, as docs/causes.md names them; of one thruster:"
                            + " \"thruster_gain (port)\". Of several that share a name, as a"
                            + " thruster's angle and tilt, all.")
    private List<String> causes = new ArrayList<>();

    @Option(
            names = "--seed",
            paramLabel = "N",
            defaultValue = "1",
            description = "Of what is drawn by lot; the same gives the same (default: 1).")
    private long seed = 1;

    @Option(
            names = "--method",
            paramLabel = "METHOD",
            defaultValue = "shooting",
            description =
                    "How causes are searched for: shooting, by what each leaves along the measured"
                            + " motion, or genetic, by models that compete (default:"
                            + " ${DEFAULT-VALUE}).")
    private Method method = Method.SHOOTING;

    @Option(
            names = "--fail-on-discrepancy",
            description = "Ends with 1 if the model is wrong, for use in CI.")
    private boolean failOnDiscrepancy;

    @Override
    public Integer call() throws DocumentException {
        try (Interruption interruption =
                new Interruption(this::tellOfStopping, PATIENCE, this::tellOfGivingUp)) {
            OutputFolder.requireWritable(folder);
            SwappedFiles.requireScenario(scenarioFile, given());
            BelievedModel model = model(ScenarioFile.load(scenarioFile, err()));
            RunFiles runs = runs(model);
            runs.notices().forEach(notice -> err().println("notice: " + notice));
            err().flush();
            Diagnosis diagnosis = diagnosis(model, runs, interruption);
            interruption.endIsInSight();
            diagnosis.notices().stream()
                    .filter(notice -> !runs.notices().contains(notice))
                    .forEach(notice -> err().println("notice: " + notice));
            err().flush();
            tell(diagnosis);
            boolean isWrong = diagnosis.verdict() != Verdict.NONE;
            return failOnDiscrepancy && isWrong ? DISCREPANCY : ExitCode.OK;
        }
    }

    private PrintWriter err() {
        return spec.commandLine().getErr();
    }

    private RunFiles runs(BelievedModel model) throws DocumentException {
        requireKnown(model);
        requireThere();
        AuvsmlMapper mapper = AuvsmlMapper.load(ContextClasses.loader());
        RunReader reader = between(new RunReader(model, format.mapping(mapper), mapper));
        return inParts(RunFiles.read(reader, fit, heldOut, reference));
    }

    /** Who asked for an end is not to wait for simulations of millions of steps. */
    private void tellOfGivingUp() {
        tellNow(
                ("given up: the best so far could not be judged within %s s, and there is no"
                                + " report; look at the notices first, as numbers in a wrong unit"
                                + " take long; else cut the runs (--from, --until), or state a"
                                + " longer time step in the scenario")
                        .formatted(PATIENCE.toSeconds()));
    }

    /** What comes takes some seconds: without a word people would press Ctrl-C once more. */
    private void tellOfStopping() {
        tellNow(
                ("stopping: the best so far is judged and reported, if that takes no more than %s"
                                + " s; Ctrl-C once more ends at once, without a report")
                        .formatted(PATIENCE.toSeconds()));
    }

    /** Beside the progress bar. */
    private void tellNow(String line) {
        err().println((StandardTerminal.isThere() ? "\n" : "") + line);
        err().flush();
    }

    private RunReader between(RunReader reader) {
        try {
            return reader.between(from, until);
        } catch (IllegalArgumentException e) {
            throw new UserError("--from, --until: " + e.getMessage(), e);
        }
    }

    private RunFiles inParts(RunFiles runs) {
        try {
            return parts.isPresent() ? runs.inParts(parts.get()) : runs;
        } catch (IllegalArgumentException e) {
            throw new UserError("--parts: " + e.getMessage(), e);
        }
    }

    private Diagnosis diagnosis(BelievedModel model, RunFiles runs, Interruption interruption) {
        try (ProgressBar bar =
                new ProgressBar(
                        err(),
                        StandardTerminal.isThere(),
                        System::nanoTime,
                        interruption::isRequested)) {
            Investigation investigation =
                    new Investigation(
                                    model,
                                    runs.fit(),
                                    runs.heldOut(),
                                    candidates(model, runs),
                                    seed,
                                    bar)
                            .by(method);
            Investigation asFarAsItPays =
                    runs.doubt() == Doubt.LASTING ? investigation.cursory() : investigation;
            Diagnosis diagnosis =
                    sound(model, runs)
                            .map(asFarAsItPays::comparedWith)
                            .orElse(asFarAsItPays)
                            .diagnose();
            List<String> notices =
                    runs.noticesAfter(diagnosis.verdict(), diagnosis.prediction().noise());
            return told(diagnosis.noticing(notices), runs);
        }
    }

    /** With what the user's choice of causes and doubtful data mean for the verdict. */
    private Diagnosis told(Diagnosis diagnosis, RunFiles runs) {
        Diagnosis ofAsked = causes.isEmpty() ? diagnosis : diagnosis.ofSomeCauses();
        return runs.doubt().isOpen(ofAsked.verdict(), ofAsked.prediction().noise())
                ? ofAsked.doubted()
                : ofAsked;
    }

    private static Optional<SoundRuns> sound(BelievedModel model, RunFiles runs) {
        try {
            return runs.reference().isEmpty()
                    ? Optional.empty()
                    : Optional.of(SoundRuns.of(model, runs.reference()));
        } catch (IllegalArgumentException e) {
            throw new UserError("--reference: " + e.getMessage(), e);
        }
    }

    private List<Cause> candidates(BelievedModel model, RunFiles runs) {
        List<Cause> library = Library.of(model, runs.fit());
        try {
            return causes.isEmpty() ? library : Library.named(causes, library);
        } catch (IllegalArgumentException e) {
            throw new UserError("--causes: " + e.getMessage(), e);
        }
    }

    /** Before runs are read. */
    private void requireKnown(BelievedModel model) {
        try {
            if (!causes.isEmpty()) {
                Library.requireKnown(causes, model);
            }
        } catch (IllegalArgumentException e) {
            throw new UserError("--causes: " + e.getMessage(), e);
        }
    }

    /** All files of runs. */
    private List<Path> given() {
        return Stream.of(fit, heldOut, reference).flatMap(List::stream).toList();
    }

    /** Runs are often meant to be where the scenario is, which reading them does not know. */
    private void requireThere() {
        List<Path> folders = Optional.ofNullable(scenarioFile.getParent()).stream().toList();
        String missing =
                given().stream()
                        .filter(Files::notExists)
                        .map(run -> MissingFile.sentence(run, folders))
                        .collect(Collectors.joining("\n"));
        if (!missing.isEmpty()) {
            throw new UserError(missing);
        }
    }

    private BelievedModel model(Scenario scenario) {
        String name = body.orElseGet(() -> theOnlyOneThatMoves(scenario));
        BelievedModel model;
        try {
            model = new BelievedModel(scenario, name);
        } catch (IllegalArgumentException e) {
            throw new UserError("%s: %s".formatted(scenarioFile, e.getMessage()), e);
        }
        if (model.tie().isPresent()) {
            throw new UserError("%s: %s".formatted(scenarioFile, model.tie().get()));
        }
        return model;
    }

    private String theOnlyOneThatMoves(Scenario scenario) {
        List<String> names =
                scenario.worldObject().stream()
                        .filter(object -> !object.fixed())
                        .map(WorldObjectDefinition::name)
                        .toList();
        if (names.size() == 1) {
            return names.getFirst();
        }
        throw new UserError(
                names.isEmpty()
                        ? "%s: nothing in the scenario can move; add the measured body as a <world-object>"
                                .formatted(scenarioFile)
                        : "%s: several objects can move (%s); say with --body which was measured"
                                .formatted(scenarioFile, some(names)));
    }

    private static String some(List<String> names) {
        String first = String.join(", ", names.subList(0, Math.min(MOST_NAMES, names.size())));
        return names.size() <= MOST_NAMES
                ? first
                : "%s and %d more".formatted(first, names.size() - MOST_NAMES);
    }

    private void tell(Diagnosis diagnosis) {
        PrintWriter out = spec.commandLine().getOut();
        try {
            Path page = Report.write(diagnosis, folder);
            Account.of(diagnosis).forEach(out::println);
            out.println();
            out.printf("The report: %s%n", page.toAbsolutePath().normalize());
            out.flush();
        } catch (IOException e) {
            throw FileTrouble.writing(folder, e);
        }
    }
}
