package org.auvsim.cli;

import org.auvsim.cli.report.FileTrouble;
import org.auvsim.cli.report.UserError;
import org.auvsim.core.step.Lanes;
import org.auvsim.experiments.bench.BenchChart;
import org.auvsim.experiments.bench.BenchCsv;
import org.auvsim.experiments.bench.BenchTable;
import org.auvsim.experiments.bench.Measurement;
import org.auvsim.experiments.bench.StepperChoice;
import org.auvsim.experiments.bench.WorkloadBench;
import org.auvsim.experiments.thesis.StageCost;
import org.auvsim.experiments.thesis.StageReport;
import org.auvsim.experiments.workload.Workload;
import org.auvsim.server.lanes.ThreadLanes;

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
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.Callable;
import java.util.function.BooleanSupplier;
import java.util.stream.Stream;

/** {@code auvsim bench}: how fast this machine runs the thesis' section 8.2. */
@Command(
        name = "bench",
        subcommands = BenchDiagnosis.class,
        description = {
            "Measures how fast worlds of colliding spheres go on (thesis, section 8.2).",
            "Prints a row for each number of bodies, and writes bench.csv and bench.png. A"
                + " body-step is one body over one time step of 0.05 s. Overlap is that of the two"
                + " spheres deepest in each other, found by a check that is not timed."
        },
        footer = {
            "",
            "Ctrl-C ends it early; what has been measured is written.",
            "",
            "Example: auvsim bench --bodies 100,1000 --repeat 3"
        })
final class Bench implements Callable<Integer> {
    private static final List<Integer> TENS = List.of(10, 20, 30, 40, 50, 60, 70, 80, 90, 100);
    private static final List<Integer> ALL =
            Stream.concat(TENS.stream(), Stream.of(1_000, 10_000, 100_000)).toList();
    private static final double QUICK_SECONDS = 5;
    private static final int USUAL_REPEAT = 5;

    /** Wall time before the timed runs of each number of bodies. */
    private static final double WARM_UP_SECONDS = 3;

    @Spec private CommandSpec spec;

    @Option(
            names = "--bodies",
            paramLabel = "N",
            split = ",",
            description = "Numbers of bodies (default: 10, 20, .., 100, 1000, 10000, 100000).")
    private List<Integer> bodies = List.of();

    @Option(
            names = "--repeat",
            paramLabel = "TIMES",
            description = "Timed runs of each (default: 5).")
    private Optional<Integer> repeat = Optional.empty();

    @Option(
            names = "--seconds",
            paramLabel = "SECONDS",
            description =
                    "World time of a run (default: 120, 30 from 10000 bodies, 10 from 100000).")
    private Optional<Double> seconds = Optional.empty();

    @Option(
            names = "--restitution",
            paramLabel = "E",
            defaultValue = "1",
            description = "Of all spheres, 0 to 1 (default: ${DEFAULT-VALUE}).")
    private double restitution;

    @Option(
            names = "--stepper",
            paramLabel = "STEPPER",
            defaultValue = "event",
            description = "One of ${COMPLETION-CANDIDATES} (default: ${DEFAULT-VALUE}).")
    private StepperChoice stepper = StepperChoice.EVENT;

    @Mixin private final LaneCount laneCount = new LaneCount();

    @Option(
            names = "--out",
            paramLabel = "FOLDER",
            defaultValue = "auvsim-bench",
            description = "Where bench.csv and bench.png go (default: ${DEFAULT-VALUE}).")
    private Path folder = Path.of("auvsim-bench");

    @Option(
            names = "--quick",
            description =
                    "10 and 100 bodies, 5 s of world time, once, where --bodies, --seconds and"
                            + " --repeat do not say otherwise: whether it works at all.")
    private boolean quick;

    @Option(
            names = "--thesis",
            description =
                    "Counts the primitive operations of the thesis' stages over 100 advancements of"
                            + " 10, 20, .., 100 bodies, takes the wall time of 120 s, and fits how"
                            + " they grow (Figures 8.4 to 8.7): thesis.csv and thesis.png.")
    private boolean thesis;

    @Override
    public Integer call() {
        checkOptions();
        // Ctrl-C waits until what there is has been written.
        try (Interruption interruption = new Interruption(() -> {});
                ThreadLanes lanes = laneCount.open()) {
            Files.createDirectories(folder);
            if (thesis) {
                reportStages(interruption::isRequested);
            } else {
                reportSpeed(lanes, interruption::isRequested);
            }
            return ExitCode.OK;
        } catch (IOException e) {
            throw FileTrouble.writing(folder, e);
        }
    }

    private void checkOptions() {
        for (int n : numbers()) {
            require(n > 0, "--bodies must be 1 or more, but one is " + n + ".");
        }
        repeat.ifPresent(
                times -> require(times > 0, "--repeat must be 1 or more, but is " + times + "."));
        require(
                restitution >= 0 && restitution <= 1,
                "--restitution must be 0 to 1, but is " + restitution + ".");
        seconds.ifPresent(
                s ->
                        require(
                                s > 0 && s < Double.POSITIVE_INFINITY,
                                "--seconds must be above 0 s and finite, but is " + s + " s."));
    }

    private static void require(boolean condition, String sentence) {
        if (!condition) {
            throw new UserError(sentence);
        }
    }

    private List<Integer> numbers() {
        if (!bodies.isEmpty()) {
            return bodies;
        }
        return quick ? List.of(10, 100) : thesis ? TENS : ALL;
    }

    private void reportSpeed(Lanes lanes, BooleanSupplier stop) throws IOException {
        WorkloadBench bench =
                new WorkloadBench(
                        stepper,
                        lanes,
                        quick ? 0 : WARM_UP_SECONDS,
                        repeat.orElse(quick ? 1 : USUAL_REPEAT));
        List<Measurement> measured = new ArrayList<>();
        BenchTable.header().forEach(this::tell);
        for (int n : numbers()) {
            Workload workload = Workload.of(n).withRestitution(restitution);
            double time = seconds.orElse(quick ? QUICK_SECONDS : workload.duration());
            bench.measure(workload, time, stop)
                    .ifPresent(
                            m -> {
                                measured.add(m);
                                tell(BenchTable.row(m));
                            });
        }
        if (!measured.isEmpty()) {
            BenchCsv.write(folder.resolve("bench.csv"), measured);
            BenchChart.write(folder.resolve("bench.png"), measured);
        }
        tell(Rows.written(measured.size(), folder.resolve("bench.csv")));
    }

    private void reportStages(BooleanSupplier stop) throws IOException {
        double time = seconds.orElse(quick ? QUICK_SECONDS : StageCost.WORLD_SECONDS);
        List<StageCost> costs = new ArrayList<>();
        tell(StageReport.header());
        for (int n : numbers()) {
            StageCost cost = StageCost.measure(Workload.of(n), time, stop);
            if (!stop.getAsBoolean()) {
                costs.add(cost);
                tell(StageReport.row(cost));
            }
        }
        StageReport.fits(costs).forEach(this::tell);
        StageReport.write(folder, costs);
        tell(Rows.written(costs.size(), folder.resolve("thesis.csv")));
    }

    private void tell(String line) {
        PrintWriter out = spec.commandLine().getOut();
        out.println(line);
        out.flush();
    }
}
