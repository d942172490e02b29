package org.auvsim.viz.source;

import static java.nio.charset.StandardCharsets.UTF_8;

import org.auvsim.auvsml.AuvsmlException;
import org.auvsim.auvsml.document.Scenario;
import org.auvsim.auvsml.document.ScenarioLoader;
import org.auvsim.auvsml.document.recording.RecordingWriter;
import org.auvsim.auvsml.mapping.AuvsmlMapper;
import org.auvsim.auvsml.recording.Recording;
import org.auvsim.core.math.Quat;
import org.auvsim.core.math.Vec3;
import org.auvsim.core.world.World;
import org.auvsim.server.RawClient;
import org.auvsim.server.net.TcpTransport;
import org.auvsim.server.replay.Recorder;
import org.auvsim.server.simulator.Simulator;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.OptionalDouble;

/** A paused simulator that records into a file, and a client of it. */
final class RecordedRun implements AutoCloseable {
    static final AuvsmlMapper MAPPER = AuvsmlMapper.load(RecordedRun.class.getClassLoader());

    /** Turns on its way, and meets the buoy after 0.3 s. */
    static final String ROBOT =
            """
            <world-object name="Robot" mass="2">
              <sphere radius="0.5"/>
              <velocity x="1" y="0" z="0"/>
              <angular-velocity x="0" y="0" z="0.4"/>
              <damping><linear x="1" y="1" z="1"/></damping>
            </world-object>
            """;

    /** At rest. */
    static final String BUOY =
            """
            <world-object name="Buoy" mass="1">
              <sphere radius="0.5"/><position x="1.3" y="0.2" z="0"/>
            </world-object>
            """;

    private final Path file;
    private final Recorder recorder;
    private final Simulator simulator;
    private final RawClient client;
    private final List<Double> times = new ArrayList<>();
    private final List<Vec3> places = new ArrayList<>();

    /** A run of a scenario of these elements, from 1.5 s on. */
    RecordedRun(Path file, String attributes, String elements) throws IOException {
        this.file = file;
        Scenario scenario = scenario(attributes, elements);
        TcpTransport tcp = TcpTransport.onLoopback(0);
        recorder =
                Recorder.start(
                        new RecordingWriter(Files.newOutputStream(file), MAPPER),
                        new Recording(Recording.VERSION, "auvsim test", 5),
                        scenario);
        simulator =
                Simulator.of(scenario)
                        .transport(tcp)
                        .rate(OptionalDouble.empty())
                        .paused()
                        .log(recorder)
                        .start();
        client = RawClient.welcomed(tcp.port());
        look();
    }

    static Scenario scenario(String attributes, String elements) {
        String text =
                "<scenario start-time=\"1.5\" %s>%s</scenario>".formatted(attributes, elements);
        try {
            return ScenarioLoader.load(RecordedRun.class.getClassLoader())
                    .parse(text.getBytes(UTF_8));
        } catch (AuvsmlException e) {
            throw new AssertionError(e.faults().toString(), e);
        }
    }

    /** The command that pushes object 1 (N). */
    static String push(double x) {
        return ("<apply-direct-force-command world-object-id='1' name='engine' orientation='WORLD'>"
                        + "<force-vector x='%s' y='0' z='0'/></apply-direct-force-command>")
                .formatted(x);
    }

    /** Makes steps, and notes where object 1 is after each. */
    RecordedRun steps(int count) {
        for (int i = 0; i < count; i++) {
            simulator.advanceTimestep();
            look();
        }
        return this;
    }

    private void look() {
        times.add(simulator.ask(World::time));
        places.add(place());
    }

    /** The world's time at the last look (s). */
    double time() {
        return times.getLast();
    }

    /** How object 1 is turned. */
    Quat turn() {
        return simulator.ask(world -> world.object(1).orientation());
    }

    private Vec3 place() {
        return simulator.ask(world -> world.object(1).position());
    }

    /** When object 1 was looked at (s). */
    List<Double> times() {
        return times;
    }

    /** Where it was then (m, world). */
    List<Vec3> places() {
        return places;
    }

    /** Sends a message and waits for the answer. */
    String ask(String message) throws IOException {
        return client.ask("a", message);
    }

    /** Ends the simulation and opens what was recorded. */
    RecordedSource open() throws Exception {
        close();
        return RecordedSource.open(file, MAPPER, _ -> {});
    }

    /** The same, keeping so many states. */
    RecordedSource open(long most) throws Exception {
        close();
        return RecordedSource.open(file, MAPPER, _ -> {}, most);
    }

    @Override
    public void close() throws IOException {
        simulator.close();
        recorder.close();
        client.close();
    }
}
