package org.auvsim.diagnosis.online;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.auvsim.auvsml.document.Scenario;
import org.auvsim.auvsml.document.ScenarioLoader;
import org.auvsim.auvsml.document.recording.RecordingReader;
import org.auvsim.auvsml.document.recording.RecordingWriter;
import org.auvsim.auvsml.mapping.AuvsmlMapper;
import org.auvsim.auvsml.recording.Recording;
import org.auvsim.core.effect.IsotropicDrag;
import org.auvsim.core.entity.Effect;
import org.auvsim.server.net.TcpTransport;
import org.auvsim.server.replay.Recorder;
import org.auvsim.server.replay.Replayer;
import org.auvsim.server.simulator.Simulator;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.OptionalDouble;

/**
 * A robot in another language, with a drag that its simulated self lacks: the server learns it from
 * its feedback, extends the running world, and a replay of the recording repeats that bit for bit.
 */
@Timeout(300)
class OnlineLearningTest {
    private static final AuvsmlMapper MAPPER =
            AuvsmlMapper.load(OnlineLearningTest.class.getClassLoader());
    private static final Path ROBOT = Path.of("..", "examples", "python", "learning.py");
    private static final Path SCENARIO = Path.of("..", "examples", "scenarios", "learning.xml");
    private static final double DRAG = 12;

    @TempDir private Path folder;
    private String said = "";
    private List<Effect> learned = List.of();
    private long hash;

    @ParameterizedTest
    @ValueSource(strings = {"learning", "genetic"})
    void theDragOfARobotIsLearnedFromItsFeedbackAndReplayed(String method) throws Exception {
        byte[] recording = recordingOf(scenario(method), "1");

        assertThat(said).contains("learned: quadratic_drag");
        assertThat(learned).hasSize(1);
        assertThat(((IsotropicDrag) learned.getFirst()).quadratic()).isCloseTo(DRAG, within(0.5));
        assertThat(hashOfReplay(recording)).isEqualTo(hash);
    }

    /** The example's, where one of the processors does all corrections. */
    private Scenario scenario(String method) throws Exception {
        String name =
                method.equals("genetic") ? "GeneticFeedbackHandler" : "LearningFeedbackHandler";
        Path file = folder.resolve("learning.xml");
        Files.writeString(
                file,
                Files.readString(SCENARIO)
                        .replace(
                                "<feedback-processor>",
                                "<feedback-processor override='" + name + "'>")
                        .replace("learning-feedback-handler", method + "-feedback-handler"));
        return ScenarioLoader.load(OnlineLearningTest.class.getClassLoader()).load(file);
    }

    private byte[] recordingOf(Scenario scenario, String seed) throws Exception {
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        TcpTransport tcp = TcpTransport.onLoopback(0);
        try (Recorder recorder =
                        Recorder.start(
                                new RecordingWriter(out, MAPPER),
                                new Recording(Recording.VERSION, "auvsim test", 5),
                                scenario);
                Simulator simulator =
                        Simulator.of(scenario)
                                .paused()
                                .rate(OptionalDouble.empty())
                                .transport(tcp)
                                .log(recorder)
                                .start()) {
            Process robot = start(tcp.port(), seed);
            said = new String(robot.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
            assertThat(robot.waitFor()).as(said).isZero();
            learned = simulator.ask(world -> world.object(1).effects());
            hash = simulator.ask(world -> world.stateHash());
        }
        return out.toByteArray();
    }

    private static Process start(int port, String seed) throws Exception {
        return new ProcessBuilder(
                        "python3", ROBOT.toString(), "127.0.0.1", Integer.toString(port), seed)
                .redirectError(ProcessBuilder.Redirect.INHERIT)
                .start();
    }

    private static long hashOfReplay(byte[] recording) throws Exception {
        RecordingReader reader =
                RecordingReader.of(new ByteArrayInputStream(recording), "run.auvsml.gz", MAPPER);
        try (Replayer replayer =
                new Replayer(
                        reader, Simulator.of(reader.scenario()).rate(OptionalDouble.empty()))) {
            while (replayer.advanceTimestep()) {
                assertThat(replayer.divergence()).isEmpty();
            }
            assertThat(replayer.divergence()).isEmpty();
            assertThat(replayer.reach().isWhole()).isTrue();
            return replayer.world().stateHash();
        }
    }
}
