package org.auvsim.auvsml.document.recording;

import static java.nio.charset.StandardCharsets.UTF_8;

import org.auvsim.auvsml.AuvsmlException;
import org.auvsim.auvsml.ErrorCode;
import org.auvsim.auvsml.Role;
import org.auvsim.auvsml.document.DocumentException;
import org.auvsim.auvsml.document.Scenario;
import org.auvsim.auvsml.document.ScenarioLoader;
import org.auvsim.auvsml.mapping.AuvsmlMapper;
import org.auvsim.auvsml.message.control.PauseSimulatorCommand;
import org.auvsim.auvsml.message.movement.MovementStateChangeMessage;
import org.auvsim.auvsml.recording.ClientCame;
import org.auvsim.auvsml.recording.ClientSent;
import org.auvsim.auvsml.recording.ClientSentUnreadable;
import org.auvsim.auvsml.recording.ClientWent;
import org.auvsim.auvsml.recording.Entry;
import org.auvsim.auvsml.recording.Happened;
import org.auvsim.auvsml.recording.Recording;
import org.auvsim.auvsml.recording.RecordingEnded;
import org.auvsim.auvsml.recording.StateHash;
import org.auvsim.auvsml.recording.StepFailed;
import org.auvsim.auvsml.recording.WaitTimedOut;
import org.auvsim.core.math.Quat;
import org.auvsim.core.math.Vec3;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Random;

/** Recordings for tests, made of every kind of entry. */
final class Recordings {
    static final AuvsmlMapper MAPPER = AuvsmlMapper.load(Recordings.class.getClassLoader());

    static final Recording BEGINNING = new Recording(Recording.VERSION, "auvsim 9", 20);

    private Recordings() {}

    static Scenario scenario() {
        try {
            return ScenarioLoader.load(Recordings.class.getClassLoader())
                    .parse("<scenario start-time='3'/>".getBytes(UTF_8));
        } catch (AuvsmlException e) {
            throw new AssertionError(e);
        }
    }

    /** The entries of so many steps of 0.05 s, with random movements. */
    static List<Entry> entries(int steps, Random random) {
        List<Entry> entries = new ArrayList<>();
        entries.add(new ClientCame(0, 0, 0, false, 3, 1, "127.0.0.1:4000", Role.ADMIN));
        for (int step = 0; step < steps; step++) {
            double time = 3 + 0.05 * step;
            entries.add(
                    new ClientSent(
                            0,
                            step,
                            1,
                            step % 2 == 0,
                            time,
                            1,
                            Optional.of("r" + step),
                            List.of(new PauseSimulatorCommand())));
            entries.add(
                    new ClientSentUnreadable(
                            0,
                            step,
                            2,
                            false,
                            time,
                            1,
                            Optional.empty(),
                            ErrorCode.INVALID_VALUE,
                            "expected a number, but found 'x'",
                            "auvsml/step-command@count",
                            7,
                            12));
            entries.add(new WaitTimedOut(0, step, 3, true, time));
            double after = 3 + 0.05 * (step + 1);
            entries.add(new Happened(0, step + 1, after, List.of(movement(after, random))));
            entries.add(StateHash.of(0, step + 1, after, random.nextLong()));
        }
        entries.add(new StepFailed(0, steps, 3 + 0.05 * steps));
        entries.add(new ClientWent(0, steps, 0, false, 3 + 0.05 * steps, 1));
        entries.add(new RecordingEnded(0, steps, 3 + 0.05 * steps, "the simulation has ended"));
        return entries;
    }

    private static MovementStateChangeMessage movement(double time, Random random) {
        return new MovementStateChangeMessage(
                time,
                47,
                false,
                vector(random),
                Quat.IDENTITY.toMatrix(),
                vector(random),
                vector(random));
    }

    private static Vec3 vector(Random random) {
        return new Vec3(random.nextGaussian(), random.nextGaussian(), random.nextGaussian());
    }

    /** Compressed, in members of three entries. */
    static byte[] written(List<Entry> entries) throws IOException {
        ByteArrayOutputStream file = new ByteArrayOutputStream();
        try (RecordingWriter writer = new RecordingWriter(file, MAPPER)) {
            writer.begin(BEGINNING, scenario());
            for (int i = 0; i < entries.size(); i++) {
                writer.write(entries.get(i));
                if (i % 3 == 2) {
                    writer.flush();
                }
            }
        }
        return file.toByteArray();
    }

    static RecordingReader reader(byte[] file) throws IOException, DocumentException {
        return RecordingReader.of(new ByteArrayInputStream(file), "run.auvsml.gz", MAPPER);
    }

    static List<Entry> rest(RecordingReader reader) throws DocumentException {
        List<Entry> entries = new ArrayList<>();
        for (Optional<Entry> next = reader.next(); next.isPresent(); next = reader.next()) {
            entries.add(next.get());
        }
        return entries;
    }
}
