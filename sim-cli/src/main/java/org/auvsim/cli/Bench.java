package org.auvsim.cli;

import org.auvsim.cli.report.FileTrouble;
import org.auvsim.cli.report.UserError;
import org.auvsim.experiments.bench.BenchChart;
import org.auvsim.experiments.bench.BenchCsv;
import org.auvsim.experiments.bench.BenchTable;
import org.auvsim.experiments.bench.Measurement;
import org.auvsim.experiments.bench.StepperChoice;
import org.auvsim.experiments.bench.WorkloadBench;
import org.auvsim.experiments.workload.Workload;

import picocli.CommandLine.Command;
import picocli.CommandLine.ExitCode;
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

/** {@code auvsim bench}: how fast this machine runs the thesis' section 8.2. */
@Command(
        name = "bench",
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
    @Spec private CommandSpec spec;

    @Option(
            names = "--bodies",
            paramLabel = "N",
            split = ",",
            defaultValue = "10,20,30,40,50,60,70,80,90,100,1000,10000,100000",
            description = "Numbers of bodies (default: ${DEFAULT-VALUE}).")
    private List<Integer> bodies = List.of();

    @Option(
            names = "--repeat",
            paramLabel = "TIMES",
            defaultValue = "5",
            description = "Timed runs of each (default: ${DEFAULT-VALUE}).")
    private int repeat;

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

    @Option(
            names = "--out",
            paramLabel = "FOLDER",
            defaultValue = "auvsim-bench",
            description = "Where bench.csv and bench.png go (default: ${DEFAULT-VALUE}).")
    private Path folder = Path.of("auvsim-bench");

    @Option(names = "--quick", description = "10 and 100 bodies, 5 s of world time, once.")
    private boolean quick;

    @Override
    public Integer call() {
        try {
            Files.createDirectories(folder);
            List<Measurement> measured = new ArrayList<>();
            // Ctrl-C waits until what there is has been written.
            try (Interruption interruption = new Interruption(() -> {})) {
                measure(measured, interruption::isRequested);
                write(measured);
            }
            return ExitCode.OK;
        } catch (IllegalArgumentException e) {
            throw new UserError("This cannot be measured: " + e.getMessage() + ".", e);
        } catch (IOException e) {
            throw FileTrouble.writing(folder, e);
        }
    }

    private void measure(List<Measurement> measured, BooleanSupplier stop) {
        WorkloadBench bench = new WorkloadBench(stepper, quick ? 1 : repeat);
        List<Workload> workloads =
                (quick ? List.of(10, 100) : bodies)
                        .stream().map(n -> Workload.of(n).withRestitution(restitution)).toList();
        BenchTable.header().forEach(this::tell);
        for (Workload workload : workloads) {
            bench.measure(workload, duration(workload), stop)
                    .ifPresent(
                            m -> {
                                measured.add(m);
                                tell(BenchTable.row(m));
                            });
        }
    }

    private double duration(Workload workload) {
        double time = seconds.orElse(quick ? 5 : workload.duration());
        if (!(time > 0) || Double.isInfinite(time)) {
            throw new UserError("--seconds must be above 0 s, but is " + time + " s.");
        }
        return time;
    }

    private void write(List<Measurement> measured) throws IOException {
        if (!measured.isEmpty()) {
            BenchCsv.write(folder.resolve("bench.csv"), measured);
            BenchChart.write(folder.resolve("bench.png"), measured);
            tell("%d rows written to %s".formatted(measured.size(), folder.resolve("bench.csv")));
        }
    }

    private void tell(String line) {
        PrintWriter out = spec.commandLine().getOut();
        out.println(line);
        out.flush();
    }
}
