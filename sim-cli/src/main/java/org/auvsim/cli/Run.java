package org.auvsim.cli;

import static java.nio.charset.StandardCharsets.UTF_8;
import static java.util.Objects.requireNonNull;

import org.auvsim.auvsml.document.DocumentException;
import org.auvsim.auvsml.document.Scenario;
import org.auvsim.auvsml.mapping.AuvsmlMapper;
import org.auvsim.auvsml.mapping.ContextClasses;
import org.auvsim.cli.report.FileTrouble;
import org.auvsim.cli.report.UserError;
import org.auvsim.core.world.World;
import org.auvsim.plot.TrajectoryPlot;
import org.auvsim.server.lanes.ThreadLanes;

import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

import java.io.IOException;
import java.io.OutputStream;
import java.io.PrintWriter;
import java.io.UncheckedIOException;
import java.io.Writer;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import java.util.concurrent.Callable;
import java.util.function.Consumer;

/** {@code auvsim run}. */
@Command(
        name = "run",
        description = "Runs a scenario without a network, as fast as it can.",
        footer = {
            "",
            "The CSV of --out has the columns",
            "  t,object,x,y,z,qw,qx,qy,qz,vx,vy,vz,wx,wy,wz",
            "and a row for each object that is not fixed, at the start and after each step: time"
                + " (s), name, position (m), orientation (quaternion, body to world), velocity"
                + " (m/s) and angular velocity (rad/s), all in world axes (x east, y north, z up).",
            "That of --readings has a row for each value that a sensor read: when it was measured"
                    + " (s), when it arrived (s), object, sensor, the value's name, and the value.",
            "Ctrl-C ends a run early; the CSV is whole up to there.",
            "",
            "Example: auvsim run examples/scenarios/tank.xml --until 120 --out run.csv"
        })
final class Run implements Callable<Integer> {
    private static final Path STANDARD_OUTPUT = Path.of("-");

    @Spec private CommandSpec spec;

    @Parameters(paramLabel = "FILE", description = "A scenario.")
    private Path file;

    @Option(
            names = "--until",
            paramLabel = "SECONDS",
            defaultValue = "60",
            description = "World time at which the run ends; by default ${DEFAULT-VALUE}.")
    private double until;

    @Option(
            names = "--out",
            paramLabel = "FILE",
            description = "Writes what moves as CSV; '-' is the standard output.")
    private Optional<Path> out = Optional.empty();

    @Option(
            names = "--readings",
            paramLabel = "FILE",
            description =
                    "Writes what sensors read as CSV, a row for each value; '-' is the standard"
                            + " output.")
    private Optional<Path> readings = Optional.empty();

    @Option(
            names = "--plot",
            paramLabel = "FILE.png",
            description =
                    "Draws the paths from above, heights and speeds of what moves, of many objects"
                            + " the first ten.")
    private Optional<Path> plot = Optional.empty();

    @Option(
            names = "--last-good",
            paramLabel = "FILE",
            description =
                    "If a step cannot be made, writes a scenario that begins at the last state that"
                            + " could be reached.")
    private Optional<Path> lastGood = Optional.empty();

    @Mixin private final LaneCount laneCount = new LaneCount();

    @Override
    public Integer call() throws DocumentException {
        Scenario scenario = ScenarioFile.load(file, spec.commandLine().getErr());
        try (ThreadLanes lanes = laneCount.open()) {
            World world = scenario.world(lanes);
            try {
                return run(world);
            } catch (RunEndedException e) {
                throw lastGood.isEmpty()
                        ? new UserError(e.sentence(), e)
                        : keep(scenario.resumedFrom(world), e);
            }
        }
    }

    private UserError keep(Scenario state, RunEndedException end) {
        Path file = lastGood.orElseThrow();
        try {
            Files.writeString(file, AuvsmlMapper.load(ContextClasses.loader()).encode(state));
        } catch (IOException e) {
            return FileTrouble.writing(file, e);
        }
        return new UserError(
                "%s; the last good state is in %s".formatted(end.sentence(), file), end);
    }

    private int run(World world) {
        if (!(until > world.time()) || Double.isInfinite(until)) {
            throw new UserError(
                    "--until must be after the scenario's start at %s s, but is %s s."
                            .formatted(world.time(), until));
        }
        if (plot.isPresent() && !plot.get().toString().endsWith(".png")) {
            throw new UserError(
                    "--plot draws PNG, so the file's name must end in .png, but is %s."
                            .formatted(plot.get()));
        }
        if (isOnOutput(out) && isOnOutput(readings)) {
            throw new UserError(
                    "--out and --readings cannot both go to the standard output; name a file for"
                            + " one of them.");
        }
        // Ctrl-C waits until all of this is closed, so that the CSV is whole.
        try (Interruption interruption = new Interruption(() -> {})) {
            if (plot.isPresent()) {
                draw(world, plot.get(), interruption);
            } else {
                runWithReadings(world, interruption);
            }
        }
        return 0;
    }

    private void draw(World world, Path target, Interruption interruption) {
        try (OutputStream to = Files.newOutputStream(target)) {
            TrajectoryPlot picture = new TrajectoryPlot(world);
            world.addListener(picture);
            // Graphics cannot be begun with once Ctrl-C has come: they end with the program, too.
            picture.png();
            runWithReadings(world, interruption);
            to.write(picture.png());
            tell("picture written to " + target);
        } catch (IOException e) {
            throw FileTrouble.writing(target, e);
        }
    }

    private void runWithReadings(World world, Interruption interruption) {
        if (readings.isPresent()) {
            recordReadings(world, readings.get(), interruption);
        } else {
            runRecorded(world, interruption);
        }
    }

    private void recordReadings(World world, Path target, Interruption interruption) {
        try (Writer writer = open(target);
                ReadingsCsv csv = new ReadingsCsv(world, writer)) {
            world.addListener(csv);
            runRecorded(world, interruption);
            tell("%d values read written to %s".formatted(csv.rows(), Rows.place(target)));
        } catch (IOException e) {
            throw FileTrouble.writing(target, e);
        }
    }

    private void runRecorded(World world, Interruption interruption) {
        if (out.isPresent()) {
            record(world, out.get(), interruption);
        } else {
            run(world, _ -> {}, interruption);
        }
    }

    private void record(World world, Path target, Interruption interruption) {
        try (Writer writer = open(target);
                TrajectoryCsv csv = new TrajectoryCsv(writer)) {
            csv.append(world);
            run(world, csv::append, interruption);
            tell(Rows.written(csv.rows(), target));
        } catch (IOException e) {
            throw FileTrouble.writing(target, e);
        } catch (UncheckedIOException e) {
            throw FileTrouble.writing(target, requireNonNull(e.getCause()));
        }
    }

    private Writer open(Path target) throws IOException {
        return target.equals(STANDARD_OUTPUT)
                ? spec.commandLine().getOut()
                : Files.newBufferedWriter(target, UTF_8);
    }

    private void run(World world, Consumer<World> afterStep, Interruption interruption) {
        Progress progress =
                new Progress(world.time(), until, spec.commandLine().getErr(), System::nanoTime);
        BatchRun run = new BatchRun(world, afterStep.andThen(w -> progress.at(w.time())));
        run.run(until, interruption::isRequested);
        tell(run.summary());
    }

    private static boolean isOnOutput(Optional<Path> target) {
        return target.equals(Optional.of(STANDARD_OUTPUT));
    }

    private void tell(String line) {
        boolean csvOnOut = isOnOutput(out) || isOnOutput(readings);
        PrintWriter to = csvOnOut ? spec.commandLine().getErr() : spec.commandLine().getOut();
        to.println(line);
        to.flush();
    }
}
