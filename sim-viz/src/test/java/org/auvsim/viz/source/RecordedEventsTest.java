package org.auvsim.viz.source;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.auvsim.core.math.Quat;
import org.auvsim.core.math.Vec3;
import org.auvsim.viz.scene.Occurrence;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;

@Timeout(60)
class RecordedEventsTest {
    @TempDir private Path folder;

    private RecordedRun run(String elements) throws IOException {
        return new RecordedRun(folder.resolve("run.auvsml.gz"), "", elements);
    }

    @Test
    void anObjectIsThereFromItsComingToItsGoing() throws Exception {
        try (RecordedRun run = run(RecordedRun.ROBOT)) {
            run.steps(4);
            double came = run.time();
            run.ask(
                    """
                    <add-world-object-command><world-object name="Late" mass="1">
                    <sphere radius="0.5"/><position x="0" y="5" z="0"/>
                    </world-object></add-world-object-command>
                    """);
            run.ask(RecordedRun.push(1).replace("id='1'", "id='2'"));
            run.steps(4);
            double went = run.time();
            run.ask("<remove-entity-command entity-id='2'/>");
            run.steps(4);
            Shown shown = new Shown(run.open());

            assertThat(shown.at(went).names()).containsExactly("Robot");
            assertThat(shown.at(went - 0.01).names()).containsExactly("Robot", "Late");
            assertThat(shown.forces(2)).hasSize(1);
            assertThat(shown.at(came - 0.01).names()).containsExactly("Robot");
            assertThat(shown.at(came).names()).containsExactly("Robot", "Late");
            Shown.assertAt(shown.place(2), new Vec3(0, 5, 0));
        }
    }

    @Test
    void forcesAndPropulsorsAreThoseOfTheTime() throws Exception {
        String driven =
                RecordedRun.ROBOT.replace(
                        "<damping>", "<propulsor name=\"Main\" maximum-thrust=\"2\"/><damping>");
        try (RecordedRun run = run(driven)) {
            run.steps(2);
            double pushed = run.time();
            run.ask(RecordedRun.push(3));
            run.ask("<set-propulsor-command world-object-id='1' name='Main' level='0.5'/>");
            run.steps(2);
            double freed = run.time();
            run.ask("<remove-force-command world-object-id='1' force-name='engine'/>");
            run.steps(2);
            Shown shown = new Shown(run.open());

            assertThat(shown.at(freed).forces(1)).isEmpty();
            assertThat(shown.at(pushed).forces(1)).hasSize(1);
            assertThat(level(shown)).contains("level=0.5");
            assertThat(shown.at(pushed - 0.01).forces(1)).isEmpty();
            assertThat(level(shown)).contains("level=0.0");
        }
    }

    private static String level(Shown shown) {
        return shown.of(1, actor -> actor.object().definition().orElseThrow().component())
                .toString();
    }

    @Test
    void aCollisionIsShownFromItsTimeOn() throws Exception {
        Shown shown = new Shown(run(RecordedRun.ROBOT + RecordedRun.BUOY).steps(12).open());

        double met = shown.at(shown.playback().end()).meetings().getFirst().time();

        assertThat(met).isBetween(1.7, 2.0);
        assertThat(shown.meetings()).hasSize(1);
        assertThat(shown.at(met - 0.001).meetings()).isEmpty();
        assertThat(shown.at(met).meetings()).hasSize(1);
        assertThat(shown.meetings().getFirst().one()).isIn(1L, 2L);
    }

    @Test
    void aMeasuredPlaceIsShownFromItsTimeOnInTheWorldsAxes() throws Exception {
        try (RecordedRun run = run(RecordedRun.ROBOT)) {
            List<Double> told = new ArrayList<>();
            List<Vec3> places = new ArrayList<>();
            List<Quat> turns = new ArrayList<>();
            for (String frame : List.of("WORLD", "NED", "BODY")) {
                run.steps(3);
                told.add(run.time());
                places.add(run.places().getLast());
                turns.add(run.turn());
                run.ask(measured(run.time(), frame));
            }
            run.steps(3);
            Shown shown = new Shown(run.open());

            assertThat(shown.at(told.get(0) - 0.01).mark(1)).isEmpty();
            Vec3 ofBody = turns.get(2).rotate(new Vec3(1, 2, 3)).plus(places.get(2));
            assertThat(shown.at(told.get(2)).mark(1).orElseThrow().distance(ofBody))
                    .isCloseTo(0, within(1e-6));
            assertThat(shown.at(told.get(1)).mark(1)).hasValue(new Vec3(2, 1, -3));
            assertThat(shown.at(told.get(0)).mark(1)).hasValue(new Vec3(1, 2, 3));
        }
    }

    private static String measured(double time, String frame) {
        return ("<different-position-feedback-message world-object-id='1' timestamp='%s'"
                        + " handler-name='IgnoreFeedbackHandler' frame='%s'>"
                        + "<virtual-position x='0' y='0' z='0'/>"
                        + "<actual-position x='1' y='2' z='3'/>"
                        + "<old-position x='0' y='0' z='0'/>"
                        + "</different-position-feedback-message>")
                .formatted(time, frame);
    }

    @Test
    void aWorldThatWentBackIsShownAsItWentOn() throws Exception {
        try (RecordedRun run = run(RecordedRun.ROBOT)) {
            run.steps(4);
            double taken = run.time();
            run.ask("<take-snapshot-command name='here'/>");
            run.ask(RecordedRun.push(50));
            run.steps(10);
            run.ask("<restore-snapshot-command name='here'/>");
            run.steps(6);
            double end = run.time();
            RecordedSource source = run.open();
            Shown shown = new Shown(source);

            assertThat(shown.playback().end()).isEqualTo(end).isLessThan(taken + 0.4);
            for (int i = 0; i < 6; i++) {
                int last = run.times().size() - 1 - i;
                Shown.assertAt(shown.at(run.times().get(last)).place(1), run.places().get(last));
            }
            assertThat(shown.at(taken).forces(1)).isEmpty();
        }
    }

    @Test
    void aWorldThatBeganAgainIsShownFromThere() throws Exception {
        try (RecordedRun run = run(RecordedRun.ROBOT + RecordedRun.BUOY)) {
            run.steps(10);
            run.ask("<reset-command/>");
            run.steps(3);
            Shown shown = new Shown(run.open());

            assertThat(shown.playback().end()).isEqualTo(run.time()).isLessThan(1.7);
            assertThat(shown.at(run.time()).names()).containsExactly("Robot", "Buoy");
            Shown.assertAt(shown.place(1), run.places().getLast());
            assertThat(shown.meetings()).isEmpty();
        }
    }

    @Test
    void lateFeedbackLeavesTheCorrectedCollisions() throws Exception {
        Path file = folder.resolve("late.auvsml.gz");
        try (RecordedRun run =
                new RecordedRun(
                        file, "feedback-horizon='0.5'", RecordedRun.ROBOT + RecordedRun.BUOY)) {
            run.steps(9);
            assertThat(
                            run.ask(
                                    measured(run.time() - 0.3, "WORLD")
                                            .replace("Ignore", "DirectPositionChange")))
                    .contains("command-done");
            run.steps(3);
            Shown shown = new Shown(run.open());

            Shown.assertAt(shown.at(run.time()).place(1), run.places().getLast());
            assertThat(run.places().getLast().z()).isCloseTo(3, within(0.1));
            assertThat(shown.meetings()).isEmpty();
        }
    }

    @Test
    void clientsComeAndGoAndAreRefusedAsTimePasses() throws Exception {
        try (RecordedRun run = run(RecordedRun.ROBOT)) {
            run.steps(2);
            run.ask("<no-such-command/>");
            run.steps(2);
            RecordedSource source = run.open();
            Shown shown = new Shown(source);

            assertThat(told(source)).hasSize(1).first().asString().contains("came from 127.0.0.1");
            shown.at(run.time());
            assertThat(told(source)).first().asString().contains("refused").contains("no-such");
            shown.at(1.5).at(run.time());
            assertThat(told(source)).first().asString().contains("refused");
        }
    }

    private static List<String> told(RecordedSource source) {
        return source.scene().drainOccurrences().stream().map(Occurrence::text).toList();
    }
}
