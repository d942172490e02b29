package org.auvsim.cli;

import ch.qos.logback.classic.Level;
import ch.qos.logback.classic.Logger;

import org.auvsim.cli.report.FileTrouble;
import org.auvsim.cli.report.UserError;
import org.auvsim.experiments.Conduct;
import org.auvsim.experiments.ThesisExperiment;
import org.auvsim.experiments.cfs.CfsExperiment;
import org.auvsim.experiments.distributed.DistributedExperiment;
import org.auvsim.experiments.runtime.RuntimeExperiment;
import org.auvsim.plot.page.Report;
import org.auvsim.plot.page.ReportPage;
import org.slf4j.LoggerFactory;

import picocli.CommandLine.Command;
import picocli.CommandLine.ExitCode;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

import java.io.IOException;
import java.io.PrintWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import java.util.concurrent.Callable;

/** {@code auvsim experiment}: chapter 8 of the thesis again. */
@Command(
        name = "experiment",
        description = {
            "Runs an experiment of the thesis' chapter 8 again and writes a page of what came of"
                    + " it: our figures beside what the thesis reported, and what changed.",
            "The page is one file that needs no network; any browser shows it."
        },
        footer = {
            "",
            "Ctrl-C ends it early, and no page is written.",
            "",
            "Example: auvsim experiment runtime --out runtime"
        })
final class Experiment implements Callable<Integer> {
    @Spec private CommandSpec spec;

    @Parameters(
            paramLabel = "NAME",
            description = {
                "cfs: one object alone, with hiccups, and led by a client (8.1);",
                "runtime: operations of the stages, and real time against world time (8.2);",
                "distributed: five clients against one process, asynchronous and in lock-step"
                        + " (8.3)."
            })
    private Choice choice = Choice.RUNTIME;

    @Option(
            names = "--out",
            paramLabel = "FOLDER",
            defaultValue = "auvsim-experiment",
            description = "Where report.html goes (default: ${DEFAULT-VALUE}).")
    private Path folder = Path.of("auvsim-experiment");

    @Option(
            names = "--quick",
            description = "A small run of some seconds: whether it works at all.")
    private boolean quick;

    @Override
    public Integer call() {
        // Clients that come and go would stand between the lines that tell how far it is.
        ((Logger) LoggerFactory.getLogger("org.auvsim.server")).setLevel(Level.WARN);
        prepareFolder();
        try (Interruption interruption = new Interruption(() -> {})) {
            Conduct conduct = new Conduct(quick, this::tellProgress, interruption::isRequested);
            Optional<Report> report = choice.experiment().run(conduct);
            if (report.isEmpty()) {
                tellProgress("ended early: no page is written");
                return ExitCode.OK;
            }
            tellReport(quick ? ofQuickRun(report.get()) : report.get());
            return ExitCode.OK;
        } catch (IOException e) {
            throw new UserError("The experiment broke off: %s".formatted(e.getMessage()), e);
        }
    }

    private void prepareFolder() {
        try {
            Files.createDirectories(folder);
        } catch (IOException e) {
            throw FileTrouble.writing(folder, e);
        }
    }

    private static Report ofQuickRun(Report report) {
        return new Report(
                report.title() + ": a quick run",
                "This is a quick run, which shows that the experiment works; its figures are not"
                        + " those to compare with the thesis. "
                        + report.summary(),
                report.sections());
    }

    private void tellReport(Report report) {
        PrintWriter out = spec.commandLine().getOut();
        try {
            Path page = ReportPage.write(folder, report);
            out.println(report.summary());
            out.printf("The page: %s%n", page.toAbsolutePath());
            out.flush();
        } catch (IOException e) {
            throw FileTrouble.writing(folder, e);
        }
    }

    private void tellProgress(String line) {
        PrintWriter err = spec.commandLine().getErr();
        err.println(line);
        err.flush();
    }

    /** The experiments. */
    enum Choice {
        CFS,
        RUNTIME,
        DISTRIBUTED;

        ThesisExperiment experiment() {
            return switch (this) {
                case CFS -> new CfsExperiment();
                case RUNTIME -> new RuntimeExperiment();
                case DISTRIBUTED -> new DistributedExperiment();
            };
        }
    }
}
