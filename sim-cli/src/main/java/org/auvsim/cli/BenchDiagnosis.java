package org.auvsim.cli;

import org.auvsim.cli.report.FileTrouble;
import org.auvsim.cli.report.UserError;
import org.auvsim.experiments.hidden.CaseKind;
import org.auvsim.experiments.scoreboard.Outcome;
import org.auvsim.experiments.scoreboard.Plan;
import org.auvsim.experiments.scoreboard.ScoreFiles;
import org.auvsim.experiments.scoreboard.ScoreTable;
import org.auvsim.experiments.scoreboard.Scoreboard;
import org.auvsim.experiments.scoreboard.Scores;

import picocli.CommandLine.Command;
import picocli.CommandLine.ExitCode;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Spec;

import java.io.IOException;
import java.io.PrintWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.Callable;

/** {@code auvsim bench diagnosis}: how well hidden causes are found. */
@Command(
        name = "diagnosis",
        description = {
            "Hides effects in simulated measurements, made by equations that are not the"
                    + " simulator's, has them diagnosed, and counts what is found.",
            "Prints a line for each case and the figures beside their targets and beside a plain"
                + " sparse regression and the genetic method, and writes cases.csv, scores.json and"
                + " report.html."
        },
        footer = {
            "",
            "Ctrl-C ends it early, with 130; what has been judged is written, and told to be"
                    + " incomplete. Ctrl-C once more ends it at once.",
            "",
            "Example: auvsim bench diagnosis --seed 1000 --cases 40 --noise 0.01"
        })
final class BenchDiagnosis implements Callable<Integer> {
    @Spec private CommandSpec spec;

    @Option(
            names = "--seed",
            paramLabel = "N",
            defaultValue = "1",
            description = "Of the first case; the others follow (default: ${DEFAULT-VALUE}).")
    private long seed = 1;

    @Option(
            names = "--cases",
            paramLabel = "N",
            defaultValue = "100",
            description = "At each noise (default: ${DEFAULT-VALUE}).")
    private int cases = 100;

    @Option(
            names = "--kind",
            paramLabel = "KIND",
            description =
                    "What is hidden, one of ${COMPLETION-CANDIDATES} (default: a mixture of all).")
    private Optional<CaseKind> kind = Optional.empty();

    @Option(
            names = "--noise",
            paramLabel = "SHARE",
            split = ",",
            description = "Of the motion's range (default: 0.001, 0.01, 0.05).")
    private List<Double> noises = Plan.NOISES;

    @Option(
            names = "--genetic",
            paramLabel = "N",
            description =
                    "So many of the cases at each noise, the first ones, are also searched by"
                            + " models that compete (default: a fifth).")
    private Optional<Integer> genetic = Optional.empty();

    @Option(
            names = "--out",
            paramLabel = "FOLDER",
            defaultValue = "auvsim-bench-diagnosis",
            description = "Where the files go (default: ${DEFAULT-VALUE}).")
    private Path folder = Path.of("auvsim-bench-diagnosis");

    @Override
    public Integer call() {
        Plan plan = plan();
        try (Interruption interruption = new Interruption(() -> {})) {
            Files.createDirectories(folder);
            List<Outcome> outcomes =
                    Scoreboard.of(
                            plan,
                            outcome -> tell(ScoreTable.line(outcome)),
                            interruption::isRequested);
            tell("");
            plan.shortfall(outcomes.size()).ifPresent(this::tell);
            ScoreTable.lines(Scores.of(plan, outcomes)).forEach(this::tell);
            ScoreFiles.write(folder, plan, outcomes);
            tell(Rows.written(outcomes.size(), folder.resolve("cases.csv")));
            return ExitCode.OK;
        } catch (IOException e) {
            throw FileTrouble.writing(folder, e);
        }
    }

    private Plan plan() {
        if (cases < 1) {
            throw new UserError("--cases must be 1 or more, but is " + cases + ".");
        }
        if (genetic.orElse(0) < 0) {
            throw new UserError("--genetic must be 0 or more, but is " + genetic.get() + ".");
        }
        for (double noise : noises) {
            if (!(noise > 0 && noise < 1)) {
                throw new UserError("--noise must be above 0 and below 1, but is " + noise + ".");
            }
        }
        return new Plan(
                seed,
                cases,
                kind.map(List::of).orElse(Plan.MIXED),
                noises,
                genetic.orElse(cases / 5));
    }

    private void tell(String line) {
        PrintWriter out = spec.commandLine().getOut();
        out.println(line);
        out.flush();
    }
}
