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
import java.net.InetSocketAddress;
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
        footer = {"", "Example: auvsim serve examples/scenarios/drift.xml --rate 2.5 --until 120"})
final class Serve implements Callable<Integer> {
    @Spec private CommandSpec spec;

    @Parameters(paramLabel = "FILE", description = "A scenario.")
    private Path file;

    @Option(
            names = "--port",
            paramLabel = "PORT",
            defaultValue = "" + Address.STANDARD_PORT,
            description = "Port to listen at, 0 for any free one; by default ${DEFAULT-VALUE}.")
    private int port;

    @Option(
            names = "--bind",
            paramLabel = "ADDRESS",
            defaultValue = "127.0.0.1",
            description =
                    "Address to listen at; by default ${DEFAULT-VALUE}, which only this machine"
                            + " reaches. Whoever reaches it may do everything.")
    private String bind = "";

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

    @Mixin private final LaneCount laneCount = new LaneCount();

    @Override
    public Integer call() throws DocumentException, IOException {
        Scenario scenario = ScenarioFile.load(file, spec.commandLine().getErr());
        requireUntilAfter(scenario.startTime());
        TcpTransport transport = new TcpTransport(address());
        try (ThreadLanes lanes = laneCount.open();
                Simulator simulator = start(scenario, lanes, transport);
                Interruption _ = new Interruption(simulator::close)) {
            PrintWriter out = spec.commandLine().getOut();
            out.printf("serving %s at %s:%d%n", file, bind, transport.port());
            out.flush();
            simulator.await();
        } catch (TransportException e) {
            throw new UserError("auvsim " + e.getMessage() + ".", e);
        }
        return 0;
    }

    private Simulator start(Scenario scenario, ThreadLanes lanes, TcpTransport transport)
            throws IOException {
        SimulatorBuilder simulator =
                ServedScenario.simulator(scenario, lanes, file)
                        .transport(transport)
                        .rate(rate.factor())
                        .until(until.map(OptionalDouble::of).orElseGet(OptionalDouble::empty))
                        .serverName(new Version().getVersion()[0]);
        return (paused ? simulator.paused() : simulator).start();
    }

    private InetSocketAddress address() {
        if (port < 0 || port > 65535) {
            throw new UserError("--port must be 0 to 65535, but is %d.".formatted(port));
        }
        InetSocketAddress address = new InetSocketAddress(bind, port);
        if (address.isUnresolved()) {
            throw new UserError("--bind: there is no address '%s' here.".formatted(bind));
        }
        return address;
    }

    private void requireUntilAfter(double start) {
        if (until.isPresent() && !(until.get() > start)) {
            throw new UserError(
                    "--until must be after the scenario's start at %s s, but is %s s."
                            .formatted(start, until.get()));
        }
    }
}
