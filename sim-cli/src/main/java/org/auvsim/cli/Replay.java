package org.auvsim.cli;

import org.auvsim.auvsml.document.DocumentException;
import org.auvsim.auvsml.document.recording.Reach;
import org.auvsim.auvsml.document.recording.RecordingReader;
import org.auvsim.auvsml.mapping.AuvsmlMapper;
import org.auvsim.auvsml.mapping.ContextClasses;
import org.auvsim.cli.report.FileTrouble;
import org.auvsim.cli.report.UserError;
import org.auvsim.server.lanes.ThreadLanes;
import org.auvsim.server.net.TcpTransport;
import org.auvsim.server.net.TransportException;
import org.auvsim.server.replay.Replayer;
import org.auvsim.server.simulator.SimulatorBuilder;

import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

import java.io.IOException;
import java.io.PrintWriter;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.nio.file.Path;
import java.util.Locale;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.concurrent.Callable;

/** {@code auvsim replay}. */
@Command(
        name = "replay",
        description =
                "Runs a recording again and holds what comes of it against what was recorded.",
        footer = {
            "",
            "It ends with 0 if all is equal, to the bit; with 1 if something is not, and tells the"
                    + " step, the object and the value that is the first; with 2 if the file cannot"
                    + " be used. A recording that was cut off is replayed as far as it goes.",
            "With --port viewers may connect, listen and ask; they cannot change anything.",
            "",
            "Example: auvsim replay run.auvsml.gz --port 40001 --rate realtime"
        })
final class Replay implements Callable<Integer> {
    private static final int DIFFERENT = 1;

    @Spec private CommandSpec spec;

    @Parameters(paramLabel = "FILE", description = "A recording of auvsim serve --record.")
    private Path file;

    @Option(
            names = "--port",
            paramLabel = "PORT",
            description =
                    "Serves the replay to viewers at this port of 127.0.0.1, 0 for any free one.")
    private Optional<Integer> port = Optional.empty();

    @Option(
            names = "--rate",
            paramLabel = "RATE",
            converter = Rate.Converter.class,
            completionCandidates = Rate.Names.class,
            description =
                    "World seconds a second: realtime, max or a number; by default realtime for"
                            + " viewers, else max.")
    private Optional<Rate> rate = Optional.empty();

    @Option(
            names = "--until",
            paramLabel = "SECONDS",
            description = "World time at which the replay ends; by default that of the recording.")
    private Optional<Double> until = Optional.empty();

    @Mixin private final LaneCount laneCount = new LaneCount();

    @Override
    public Integer call() throws DocumentException {
        AuvsmlMapper mapper = AuvsmlMapper.load(ContextClasses.loader());
        try (ThreadLanes lanes = laneCount.open();
                RecordingReader recording = RecordingReader.open(file, mapper);
                Replayer replayer = replayer(recording, lanes)) {
            return replay(replayer);
        } catch (TransportException e) {
            throw new UserError("auvsim " + e.getMessage() + ".", e);
        } catch (IOException e) {
            throw FileTrouble.reading(file, e);
        }
    }

    private Replayer replayer(RecordingReader recording, ThreadLanes lanes) {
        requireUntilAfter(recording.scenario().startTime());
        SimulatorBuilder simulator =
                ServedScenario.simulator(recording.scenario(), lanes, file)
                        .serverName(recording.recording().server())
                        .rate(rate.orElseGet(this::usualRate).factor());
        if (port.isEmpty()) {
            return new Replayer(recording, simulator);
        }
        TcpTransport transport = new TcpTransport(address(port.get()));
        Replayer replayer = new Replayer(recording, simulator.transport(transport));
        tell("replaying %s at 127.0.0.1:%d".formatted(file, transport.port()));
        return replayer;
    }

    private void requireUntilAfter(double start) {
        if (until.isPresent() && !(until.get() > start)) {
            throw new UserError(
                    "--until must be after the recording's start at %s s, but is %s s."
                            .formatted(start, until.get()));
        }
    }

    private static InetSocketAddress address(int port) {
        if (port < 0 || port > 65535) {
            throw new UserError("--port must be 0 to 65535, but is %d.".formatted(port));
        }
        return new InetSocketAddress(InetAddress.getLoopbackAddress(), port);
    }

    private Rate usualRate() {
        return port.isPresent() ? Rate.REAL_TIME : new Rate(OptionalDouble.empty());
    }

    private int replay(Replayer replayer) throws DocumentException {
        Progress progress =
                new Progress(
                        replayer.world().time(),
                        until.orElse(Double.POSITIVE_INFINITY),
                        spec.commandLine().getErr(),
                        System::nanoTime);
        boolean goesOn;
        try (Interruption interruption = new Interruption(replayer::hurry)) {
            do {
                goesOn = replayer.advanceTimestep();
                progress.at(replayer.world().time());
            } while (goesOn
                    && replayer.divergence().isEmpty()
                    && !interruption.isRequested()
                    && !hasReachedEnd(replayer));
        }
        replayer.divergence().ifPresent(found -> tell(file + ": " + found.sentence()));
        if (replayer.divergence().isPresent()) {
            return DIFFERENT;
        }
        tellChecked(replayer.steps(), replayer.hashes());
        if (!goesOn) {
            tellEnd(replayer.reach());
        }
        return 0;
    }

    private void tellChecked(long steps, long hashes) {
        if (steps > 0) {
            tell(
                    String.format(
                            Locale.ROOT,
                            "%,d %s replayed, %,d %s equal",
                            steps,
                            steps == 1 ? "step" : "steps",
                            hashes,
                            hashes == 1 ? "hash" : "hashes"));
        } else if (hashes > 0) {
            tell("no step is recorded: nothing but the beginning was checked");
        } else {
            tell("no step is recorded: nothing was checked");
        }
    }

    private boolean hasReachedEnd(Replayer replayer) {
        return until.isPresent() && replayer.world().time() >= until.get() - 1e-9;
    }

    private void tellEnd(Reach reach) {
        if (!reach.isWhole()) {
            tell(
                    String.format(
                            Locale.ROOT,
                            "%s: it reaches step %,d, %s s: %s",
                            file,
                            reach.step(),
                            reach.timestamp(),
                            reach.reason()));
        }
    }

    private void tell(String line) {
        PrintWriter out = spec.commandLine().getOut();
        out.println(line);
        out.flush();
    }
}
