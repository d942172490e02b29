package org.auvsim.viz.source;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import static java.nio.charset.StandardCharsets.UTF_8;

import org.auvsim.auvsml.document.DocumentException;
import org.auvsim.core.math.Vec3;
import org.auvsim.viz.scene.Movement;
import org.auvsim.viz.scene.Occurrence;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.zip.GZIPInputStream;

@Timeout(60)
class RecordedSourceTest {
    @TempDir private Path folder;

    private RecordedRun run(String elements) throws IOException {
        return new RecordedRun(folder.resolve("run.auvsml.gz"), "", elements);
    }

    @Test
    void showsRecordedPlacesAtTheirTimesAndWhatLiesBetween() throws Exception {
        RecordedRun run = run(RecordedRun.ROBOT + RecordedRun.BUOY).steps(12);
        Shown shown = new Shown(run.open());

        assertThat(shown.playback().start()).isEqualTo(1.5);
        assertThat(shown.playback().end()).isEqualTo(run.time());
        for (int i = 12; i >= 0; i--) {
            Shown.assertAt(shown.at(run.times().get(i)).place(1), run.places().get(i));
        }
        for (int i = 0; i < 12; i++) {
            double time = (run.times().get(i) + run.times().get(i + 1)) / 2;
            Vec3 middle = run.places().get(i).plus(run.places().get(i + 1)).times(0.5);
            Shown.assertAt(shown.at(time).place(1), middle);
        }
    }

    @Test
    void velocitiesAreThoseOfTheRecordedMotion() throws Exception {
        String turning =
                """
                <world-object name="Top" mass="2"><sphere radius="0.5"/>
                  <velocity x="1" y="0" z="0"/><angular-velocity x="0" y="0" z="0.4"/>
                </world-object>
                """;
        RecordedSource source = run(turning).steps(6).open();
        new Shown(source).at(1.61).names();

        Movement motion = source.scene().motion(1).orElseThrow();

        assertThat(motion.velocity().distance(new Vec3(1, 0, 0))).isCloseTo(0, within(1e-9));
        assertThat(motion.angularVelocity().distance(new Vec3(0, 0, 0.4)))
                .isCloseTo(0, within(1e-4));
    }

    @Test
    void whatStoodStillStandsUntilTheStepInWhichItMoves() throws Exception {
        try (RecordedRun run = run(RecordedRun.BUOY)) {
            run.steps(10);
            run.ask(RecordedRun.push(10));
            run.steps(3);
            Shown shown = new Shown(run.open());

            Shown.assertAt(shown.at(1.98).place(1), new Vec3(1.3, 0.2, 0));
            assertThat(shown.at(2.04).place(1).x()).isGreaterThan(1.3);
        }
    }

    @Test
    void theTrailIsFilledAfterAJump() throws Exception {
        RecordedRun run = run(RecordedRun.ROBOT).steps(12);
        Shown shown = new Shown(run.open());

        shown.at(run.time()).at(run.times().get(6));

        // Steps of 0.05 s, of which each second is kept.
        int length = shown.of(1, actor -> actor.trailLength());
        assertThat(length).isEqualTo(4);
        assertThat((double) shown.of(1, actor -> actor.trailTime(0))).isEqualTo(1.5);
        assertThat((double) shown.of(1, actor -> actor.trail(3, 0)))
                .isEqualTo(run.places().get(6).x());
    }

    @Test
    void playsAtARateUntilTheEnd() throws Exception {
        RecordedRun run = run(RecordedRun.ROBOT).steps(20);
        Shown shown = new Shown(run.open()).after(0);
        Playback playback = shown.playback();
        playback.rate(2);
        playback.play(true);

        assertThat(shown.after(0.2).playback().time()).isCloseTo(1.9, within(1e-9));
        Shown.assertAt(shown.place(1), run.places().get(8));
        assertThat(shown.after(5).playback().time()).isEqualTo(run.time());
        assertThat(playback.isPlaying()).isFalse();
        playback.play(true);
        assertThat(playback.time()).isEqualTo(1.5);
    }

    @Test
    void goesOnAndBackByRecordedSteps() throws Exception {
        RecordedRun run = run(RecordedRun.ROBOT).steps(6);
        Playback playback = new Shown(run.open()).at(run.times().get(3) - 0.01).playback();

        playback.step(1);
        assertThat(playback.time()).isEqualTo(run.times().get(3));
        playback.step(-2);
        assertThat(playback.time()).isEqualTo(run.times().get(1));
        playback.seek(run.times().get(3) - 0.01);
        playback.step(-1);
        assertThat(playback.time()).isEqualTo(run.times().get(2));
        playback.step(100);
        assertThat(playback.time()).isEqualTo(run.time());
        playback.seek(-7);
        assertThat(playback.time()).isEqualTo(1.5);
    }

    private static List<String> told(RecordedSource source) {
        return source.scene().drainOccurrences().stream().map(Occurrence::text).toList();
    }

    @Test
    void ofALongRecordingEverySecondStateIsShown() throws Exception {
        RecordedRun run = run(RecordedRun.ROBOT).steps(40);
        RecordedSource source = run.open(60);
        Shown shown = new Shown(source);

        assertThat(source.status()).contains("one state of 2 is shown");
        assertThat(told(source)).anyMatch(text -> text.contains("one state of 2"));
        for (int i = 0; i <= 40; i += 2) {
            Shown.assertAt(shown.at(run.times().get(i)).place(1), run.places().get(i));
        }
        Shown.assertAt(
                shown.at(run.times().get(7)).place(1),
                run.places().get(6).plus(run.places().get(8)).times(0.5));
    }

    @Test
    void oneThatWasCutOffIsShownAsFarAsItGoes() throws Exception {
        run(RecordedRun.ROBOT).steps(10).open();
        Path cut = folder.resolve("cut.auvsml");
        String text = unpacked();
        Files.writeString(cut, text.substring(0, text.indexOf("step=\"7\"")));

        RecordedSource source = RecordedSource.open(cut, RecordedRun.MAPPER, _ -> {});

        assertThat(source.status()).contains("cut off");
        assertThat(source.playback().orElseThrow().end()).isCloseTo(1.8, within(1e-9));
    }

    private String unpacked() throws IOException {
        try (var in = new GZIPInputStream(Files.newInputStream(folder.resolve("run.auvsml.gz")))) {
            return new String(in.readAllBytes(), UTF_8);
        }
    }

    @Test
    void oneThatIsDamagedIsRefused() throws Exception {
        run(RecordedRun.ROBOT).steps(10).open();
        Path damaged = folder.resolve("run.auvsml.gz");
        byte[] bytes = Files.readAllBytes(damaged);
        Arrays.fill(bytes, bytes.length / 2, bytes.length / 2 + 8, (byte) 0x55);
        Files.write(damaged, bytes);

        assertRefused(damaged, "damaged");
    }

    @Test
    void whatIsNoRecordingIsRefused() throws Exception {
        Path scenario = Files.writeString(folder.resolve("a.xml"), "<scenario/>");

        assertRefused(scenario, "is a scenario, no recording");
        assertRefused(folder.resolve("none"), "there is no such file");
    }

    private static void assertRefused(Path file, String sentence) {
        assertThatThrownBy(() -> RecordedSource.open(file, RecordedRun.MAPPER, _ -> {}))
                .isInstanceOf(DocumentException.class)
                .hasMessageStartingWith(file.toString())
                .hasMessageContaining(sentence);
    }

    @Test
    void theShareThatHasBeenReadGoesUpToAll() throws Exception {
        run(RecordedRun.ROBOT).steps(10).open();
        List<Double> shares = new ArrayList<>();

        RecordedSource.open(folder.resolve("run.auvsml.gz"), RecordedRun.MAPPER, shares::add);

        assertThat(shares).isSorted().endsWith(1.0);
    }
}
