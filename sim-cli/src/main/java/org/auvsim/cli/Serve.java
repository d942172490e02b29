package org.auvsim.cli;

import org.auvsim.auvsml.document.DocumentException;
import org.auvsim.auvsml.document.Scenario;
import org.auvsim.cli.report.UserError;
import org.auvsim.server.lanes.ThreadLanes;
import org.auvsim.server.net.TcpTransport;
import org.auvsim.server.net.TransportException;
import org.auvsim.server.simulator.Simulator;
import org.auvsim.server.simulator.SimulatorBuilder;

import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

import java.io.IOException;
import java.io.PrintWriter;
import java.nio.file.Path;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.concurrent.Callable;

/** {@code auvsim serve}. */
@Command(
        name = "serve",
        description =
                "Serves a scenario to clients over TCP, until a client or Ctrl-C ends it or --until"
                        + " is reached.",
        footer = {
            "",
            "It ends with 1 if the recording broke off before the simulation ended.",
            "",
            "Example: auvsim serve examples/scenarios/drift.xml --rate 2.5 --until 120"
        })
final class Serve implements Callable<Integer> {
    private static final int BROKEN_OFF = 1;

    @Spec private CommandSpec spec;

    @Parameters(paramLabel = "FILE", description = "A scenario.")
    private Path file;

    @Mixin private final Admission admission = new Admission();

    @Option(
            names = "--rate",
            paramLabel = "RATE",
            defaultValue = "realtime",
            converter = Rate.Converter.class,
            completionCandidates = Rate.Names.class,
            description =
                    "World seconds a second: realtime, max (as fast as possible) or a number; by"
                            + " default ${DEFAULT-VALUE}.")
    private Rate rate = Rate.REAL_TIME;

    @Option(
            names = "--until",
            paramLabel = "SECONDS",
            description = "World time at which the simulation ends; by default it does not.")
    private Optional<Double> until = Optional.empty();

    @Option(
            names = "--paused",
            description = "Stands still until a client sends resume-simulator-command.")
    private boolean paused;

    @Mixin private final RecordingOptions recordingOptions;

    @Mixin private final LaneCount laneCount = new LaneCount();

    Serve() {
        this(new RecordingOptions());
    }

    Serve(RecordingOptions recordingOptions) {
        this.recordingOptions = recordingOptions;
    }

    @Override
    public Integer call() throws DocumentException, IOException {
        Scenario scenario = ScenarioFile.load(file, spec.commandLine().getErr());
        requireUntilAfter(scenario.startTime());
        TcpTransport transport = new TcpTransport(admission.address());
        try (ThreadLanes lanes = laneCount.open();
                RecordingUnderWay recording = recordingOptions.start(scenario, version());
                Simulator simulator = start(scenario, lanes, transport, recording);
                Interruption _ = new Interruption(() -> end(simulator, recording))) {
            recording.tellIfEnded(simulator);
            PrintWriter out = spec.commandLine().getOut();
            out.printf(
                    "serving %s at %s:%d%n",
                    file, admission.address().getHostString(), transport.port());
            out.flush();
            simulator.await();
            end(simulator, recording);
            return outcome(recording);
        } catch (TransportException e) {
            throw new UserError("auvsim " + e.getMessage() + ".", e);
        }
    }

    private int outcome(RecordingUnderWay recording) {
        Optional<String> failure = recording.failure();
        failure.ifPresent(
                why -> {
                    PrintWriter err = spec.commandLine().getErr();
                    err.println("The recording ends before the simulation did: " + why + ".");
                    err.flush();
                });
        return failure.isPresent() ? BROKEN_OFF : 0;
    }

    /** The process may end when this is done. */
    private static void end(Simulator simulator, RecordingUnderWay recording) {
        simulator.close();
        recording.close();
    }

    private Simulator start(
            Scenario scenario,
            ThreadLanes lanes,
            TcpTransport transport,
            RecordingUnderWay recording)
            throws IOException {
        SimulatorBuilder simulator =
                ServedScenario.simulator(scenario, lanes, file)
                        .transport(transport)
                        .role(admission.role())
                        .rate(rate.factor())
                        .until(until.map(OptionalDouble::of).orElseGet(OptionalDouble::empty))
                        .serverName(version());
        return recording.of(paused ? simulator.paused() : simulator).start();
    }

    private static String version() throws IOException {
        return new Version().getVersion()[0];
    }

    private void requireUntilAfter(double start) {
        if (until.isPresent() && !(until.get() > start)) {
            throw new UserError(
                    "--until must be after the scenario's start at %s s, but is %s s."
                            .formatted(start, until.get()));
        }
    }
}
