package org.auvsim.junit;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;
import static org.auvsim.junit.TrajectoryAssert.assertThatTrajectory;

import org.auvsim.auvsml.document.Scenario;
import org.auvsim.auvsml.document.ScenarioLoader;
import org.auvsim.auvsml.document.recording.RecordingWriter;
import org.auvsim.auvsml.mapping.AuvsmlMapper;
import org.auvsim.auvsml.recording.Recording;
import org.auvsim.server.replay.Recorder;
import org.auvsim.server.simulator.Simulator;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.OptionalDouble;
import java.util.zip.GZIPInputStream;

/**
 * A recording of the drift, as it is and edited: a scenario that is not the one that was run stands
 * for code that is another one.
 */
class RecordingTest {
    private static final ClassLoader LOADER = RecordingTest.class.getClassLoader();
    private static final Path DRIFT = Path.of("src/test/resources/org/auvsim/junit/drift.xml");

    @TempDir private Path folder;
    private Path file;

    @BeforeEach
    void record() throws Exception {
        file = folder.resolve("drift.auvsml.gz");
        Scenario scenario = ScenarioLoader.load(LOADER).load(DRIFT);
        RecordingWriter writer =
                new RecordingWriter(Files.newOutputStream(file), AuvsmlMapper.load(LOADER));
        Recording beginning = new Recording(Recording.VERSION, "auvsim", 20);
        try (Recorder recorder = Recorder.start(writer, beginning, scenario);
                Simulator simulator =
                        Simulator.of(scenario)
                                .log(recorder)
                                .rate(OptionalDouble.empty())
                                .until(OptionalDouble.of(6))
                                .start()) {
            simulator.await();
        }
    }

    @Test
    void theSameCodeGoesTheSameWayToTheBit() throws Exception {
        Replay replay = replay(Double.NaN);

        assertThat(replay.divergence()).isEmpty();
        assertThat(replay.end()).isCloseTo(6, within(1e-9));
        assertThat(replay.collisions()).hasSize(1);
        assertThat(replay.trajectories())
                .hasSize(4)
                .allSatisfy(body -> assertThatTrajectory(body).matchesRecording(0, 1e-12));
    }

    @Test
    void aReplayMayEndEarlier() throws Exception {
        Replay replay = replay(3);

        assertThat(replay.end()).isCloseTo(3, within(1e-9));
        assertThatTrajectory(replay.trajectory("AUV")).matchesRecording(0).collidesWithNothing();
        assertThatThrownBy(() -> replay(-1))
                .isInstanceOf(ReplayException.class)
                .hasMessage(
                        "drift.auvsml.gz begins at 0 s: until must be after that, but is -1 s.");
    }

    @Test
    void aReplayCannotEndAfterTheRecording() {
        assertThatThrownBy(() -> replay(1000))
                .isInstanceOf(ReplayException.class)
                .hasMessage(
                        "drift.auvsml.gz ends at 6 s: until must not be after that, but is 1000"
                                + " s.");
    }

    @Test
    void aRecordingIsKnownByWhatItHolds() throws Exception {
        file = Files.move(file, folder.resolve("drift.auvsml"));

        assertThat(replay(3).divergence()).isEmpty();
    }

    /** 0.1 m/s faster, it is 0.325 m ahead after 3.25 s, and most where the recorded one ends. */
    @Test
    void anotherCourseIsToldWithTimeAndPlaces() throws Exception {
        edit("(name=\"Escort\"(?s:.)*?)<velocity x=\"1.0\"", "$1<velocity x=\"1.1\"");
        Replay replay = replay(Double.NaN);

        assertThatTrajectory(replay.trajectory("Escort")).matchesRecording(0.61);
        assertThatTrajectory(replay.trajectory("AUV")).matchesRecording(0);
        assertThatThrownBy(
                        () ->
                                assertThatTrajectory(replay.trajectory("Escort"))
                                        .matchesRecording(0.322))
                .isInstanceOf(AssertionError.class)
                .hasMessageStartingWith(
                        "'Escort' differs from the recording at 3.25 s: (3.575, 2, -2), 0.325 m"
                            + " from the recorded (3.25, 2, -2), allowed 0.322 m; most, 0.6 m, at 6"
                            + " s")
                .hasMessageContaining("picture: ");
        assertThat(replay.divergence().orElseThrow())
                .contains("'Escort' (id 2)", "step 0")
                .doesNotContain("\n");
    }

    /** It turns by 0.5 rad/s when it was recorded, and by 0.6 rad/s now. */
    @Test
    void anotherTurnIsTold() throws Exception {
        edit("z=\"0.5\"", "z=\"0.6\"");
        Trajectory escort = replay(Double.NaN).trajectory("Escort");

        assertThatTrajectory(escort).matchesRecording(1e-9).matchesRecording(1e-9, 0.61);
        assertThatThrownBy(() -> assertThatTrajectory(escort).matchesRecording(1e-9, 0.1025))
                .hasMessageStartingWith(
                        "'Escort' differs from the recording at 1.05 s: it is turned by 0.105 rad,"
                                + " allowed 0.1025 rad");
    }

    @Test
    void aBodyThatTheRecordingLacksIsTold() throws Exception {
        edit("<world-object id=\"2\" type=\"WorldObject\" name=\"Escort\"/>", "");
        edit(
                "<movement-state-change-message[^>]*world-object-id=\"2\"(?s:.)*?</movement-state-change-message>",
                "");

        assertThatThrownBy(
                        () ->
                                assertThatTrajectory(replay(Double.NaN).trajectory("Escort"))
                                        .matchesRecording(1))
                .hasMessageStartingWith(
                        "'Escort' is here, and not in the recording, at 0 s: at (0, 2, -2),"
                                + " expected no such body");
    }

    @Test
    void oneThatWasCutOffIsReplayedAsFarAsItGoes() throws Exception {
        unpack();
        byte[] whole = Files.readAllBytes(file);
        Files.write(file, Arrays.copyOf(whole, whole.length * 3 / 4));
        Replay replay = replay(Double.NaN);

        assertThat(replay.end()).isBetween(3.0, 5.9);
        assertThatTrajectory(replay.trajectory("AUV")).matchesRecording(0);
    }

    @Test
    void whatIsNoRecordingIsExplained() throws IOException {
        Files.writeString(file, "<scenario/>");

        assertThatThrownBy(() -> replay(Double.NaN))
                .isInstanceOf(ReplayException.class)
                .hasMessageContaining("drift.auvsml.gz")
                .message()
                .hasLineCount(1);
    }

    /** A shorter run would let assertions pass that the whole one breaks. */
    @Test
    void aRunThatCannotReachTheRecordingsEndIsNone() throws Exception {
        edit(
                "<event-stepper/>",
                "<snapshot-stepper><maximum-speed-restricter speed=\"0.9\"/></snapshot-stepper>");

        assertThatThrownBy(() -> replay(Double.NaN))
                .isInstanceOf(ReplayException.class)
                .hasMessageStartingWith(
                        "drift.auvsml.gz cannot be replayed beyond step 0 of 120, 0 s")
                .hasMessageContaining("state a higher speed");
    }

    private Replay replay(double until) throws ReplayException {
        return new Replay(
                new ReplayedFile("drift.auvsml.gz", file, LOADER).replay(until),
                (name, png) -> Files.write(folder.resolve(name), png));
    }

    /** Changes a text of the recording, which is there. */
    private void edit(String pattern, String replacement) throws IOException {
        unpack();
        String text = Files.readString(file);
        String edited = text.replaceAll(pattern, replacement);
        assertThat(edited).isNotEqualTo(text);
        Files.writeString(file, edited);
    }

    private void unpack() throws IOException {
        byte[] bytes = Files.readAllBytes(file);
        if (bytes[0] == 0x1f) {
            try (var unpacked = new GZIPInputStream(new ByteArrayInputStream(bytes))) {
                Files.write(file, unpacked.readAllBytes());
            }
        }
    }
}
