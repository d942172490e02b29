package org.auvsim.server.replay;

import static java.nio.charset.StandardCharsets.UTF_8;

import org.auvsim.auvsml.AuvsmlException;
import org.auvsim.auvsml.document.Scenario;
import org.auvsim.auvsml.document.ScenarioLoader;
import org.auvsim.auvsml.document.recording.RecordingReader;
import org.auvsim.auvsml.document.recording.RecordingWriter;
import org.auvsim.auvsml.mapping.AuvsmlMapper;
import org.auvsim.auvsml.recording.Entry;
import org.auvsim.auvsml.recording.Recording;
import org.auvsim.server.simulator.Simulator;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;

/** Scenarios to record, and how recordings are made and read in tests. */
final class Recorded {
    static final AuvsmlMapper MAPPER = AuvsmlMapper.load(Recorded.class.getClassLoader());

    private Recorded() {}

    /** A robot in a current between two balls that it hits, with this time-stepper. */
    static Scenario scenario(String timestepper) {
        return scenario(timestepper, "");
    }

    /** The same with more attributes. */
    static Scenario scenario(String timestepper, String attributes) {
        String text =
                """
                <scenario start-time="1.5" %s>
                  %s
                  <world-object id="1" name="Robot" mass="2">
                    <sphere radius="0.5"/>
                    <velocity x="1" y="0" z="0"/>
                    <damping><linear x="1" y="1" z="1"/></damping>
                  </world-object>
                  <world-object id="2" name="Buoy" mass="1">
                    <sphere radius="0.5"/><position x="1.2" y="0.1" z="0"/>
                  </world-object>
                  <world-object id="3" name="Float" mass="1">
                    <sphere radius="0.5"/><position x="-1.2" y="0.1" z="0"/>
                  </world-object>
                </scenario>
                """
                        .formatted(attributes, timestepper);
        try {
            return ScenarioLoader.load(Recorded.class.getClassLoader()).parse(text.getBytes(UTF_8));
        } catch (AuvsmlException e) {
            throw new AssertionError(e.faults().toString(), e);
        }
    }

    /** Begins to record to {@code out}, with a hash every five steps. */
    static Recorder recorder(OutputStream out, Scenario scenario) throws IOException {
        return Recorder.start(
                new RecordingWriter(out, MAPPER),
                new Recording(Recording.VERSION, "auvsim test", 5),
                scenario);
    }

    static RecordingReader reader(byte[] recording) throws Exception {
        return RecordingReader.of(new ByteArrayInputStream(recording), "run.auvsml.gz", MAPPER);
    }

    static List<Entry> entries(byte[] recording) throws Exception {
        List<Entry> entries = new ArrayList<>();
        RecordingReader reader = reader(recording);
        for (Optional<Entry> next = reader.next(); next.isPresent(); next = reader.next()) {
            entries.add(next.get());
        }
        return entries;
    }

    /** A replay of a recording. */
    static Replayer replayer(byte[] recording) throws Exception {
        RecordingReader reader = reader(recording);
        return new Replayer(reader, Simulator.of(reader.scenario()).rate(OptionalDouble.empty()));
    }
}
