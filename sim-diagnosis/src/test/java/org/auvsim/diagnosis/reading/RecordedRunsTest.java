package org.auvsim.diagnosis.reading;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import org.auvsim.auvsml.document.DocumentException;
import org.auvsim.auvsml.run.ColumnMapping;
import org.auvsim.core.entity.Frame;
import org.auvsim.core.math.Quat;
import org.auvsim.core.math.Vec3;
import org.auvsim.diagnosis.run.Channel;
import org.auvsim.diagnosis.run.Command;
import org.auvsim.diagnosis.run.MeasuredRun;
import org.auvsim.diagnosis.run.ScheduledForce;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;

/** Recordings written by hand, in the form of docs/recording.md. */
class RecordedRunsTest {
    private static final double STEP = 0.1;
    private static final String PLAN =
            "<propulsor-schedule name='plan' propulsor='main'>"
                    + "<timed-level at='0' level='1'/></propulsor-schedule>";

    @TempDir private Path folder;
    private final StringBuilder text =
            new StringBuilder("<recording version=\"1\" server=\"by hand\"/>\n" + Rov.SCENARIO);
    private int step;
    private int index;

    private RunFile read() throws IOException, DocumentException {
        Path file = Rov.write(folder.resolve("dive.auvsml"), text.toString());
        return Rov.reader(ColumnMapping.USUAL).read(file);
    }

    private static double time(int step) {
        return STEP * step;
    }

    private void sent(boolean duringStep, String message) {
        text.append(
                String.format(
                        Locale.ROOT,
                        "<client-sent step=\"%d\" index=\"%d\" during-step=\"%d\" timestamp=\"%s\""
                                + " session-id=\"1\">%s</client-sent>%n",
                        step,
                        index,
                        duringStep ? 1 : 0,
                        time(step),
                        message));
        index++;
    }

    /** What the robot says of the end of the step that waits for it, then that end. */
    private void step(String measured) {
        sent(
                true,
                "<different-state-feedback-message world-object-id=\"1\" timestamp=\"%s\" handler-name=\"any\" %s</different-state-feedback-message>"
                        .formatted(time(step + 1), measured));
        step++;
        index = 0;
        text.append("<happened step=\"%d\" timestamp=\"%s\"/>\n".formatted(step, time(step)));
    }

    private void steps(int count) {
        for (int i = 0; i < count; i++) {
            step("><position x=\"%d\" y=\"2\" z=\"3\"/>".formatted(step));
        }
    }

    @Test
    void feedbackIsWhatWasMeasured() throws Exception {
        steps(20);

        RunFile file = read();

        MeasuredRun run = file.runs().getFirst();
        assertThat(run.name()).isEqualTo("dive");
        assertThat(run.size()).isEqualTo(20);
        assertThat(run.time(0)).isEqualTo(0.1);
        assertThat(run.vector(Channel.POSITION, 7)).contains(new Vec3(7, 2, 3));
        assertThat(run.measures(Channel.VELOCITY)).isFalse();
        assertThat(file.notices()).isEmpty();
    }

    @Test
    void commandsHoldFromTheStepThatFeelsThemFirst() throws Exception {
        sent(false, level("main", 0.1));
        steps(5);
        sent(false, level("main", 0.2));
        steps(5);
        sent(true, level("main", 0.3));
        steps(10);

        MeasuredRun run = read().runs().getFirst();

        Command main = run.commands().getFirst();
        assertThat(main.name()).isEqualTo("main");
        assertThat(main.level(0)).isEqualTo(0.1);
        assertThat(levelAt(run, main, 0.4)).isEqualTo(0.1);
        assertThat(levelAt(run, main, 0.5)).isEqualTo(0.2);
        assertThat(levelAt(run, main, 1.0)).isEqualTo(0.2);
        assertThat(levelAt(run, main, 1.1)).isEqualTo(0.3);
        assertThat(run.commands().getLast().level(19)).as("rudder").isZero();
    }

    /** That it was never told anything does not mean that it stood still. */
    @Test
    void whatAScheduleDirectsIsToldByClientsAlone() throws Exception {
        text.replace(text.indexOf(Rov.SCENARIO), text.length(), Rov.with(PLAN));
        steps(20);
        assertThat(commands()).containsExactly("rudder");

        sent(false, level("main", 0.2));
        steps(1);
        assertThat(commands()).containsExactly("main", "rudder");
    }

    /** The scenario may be that of several runs, each with a schedule of its own. */
    @Test
    void whatTheRecordedScenarioAloneDirectsIsDoubtful() throws Exception {
        steps(20);
        String recorded = text.toString().replace(Rov.SCENARIO, Rov.with(PLAN));
        Path file = Rov.write(folder.resolve("dive.auvsml"), recorded);

        RunFile read = Rov.reader(ColumnMapping.USUAL).read(file);

        assertThat(read.notices())
                .contains(
                        file
                                + ": a schedule or another behavior of the recorded scenario"
                                + " directed 'main', and none of the scenario given does: it holds"
                                + " what that states; add what directed it to the scenario");
        assertThat(read.doubt()).isEqualTo(Doubt.LASTING);
        assertThat(Rov.reader(Rov.with(PLAN)).read(file).doubt()).isEqualTo(Doubt.NONE);
    }

    private List<String> commands() throws IOException, DocumentException {
        Path file = Rov.write(folder.resolve("dive.auvsml"), text.toString());
        MeasuredRun run = Rov.reader(Rov.with(PLAN)).read(file).runs().getFirst();
        return run.commands().stream().map(Command::name).toList();
    }

    private static String level(String name, double level) {
        return "<set-propulsor-command world-object-id=\"1\" name=\"%s\" level=\"%s\"/>"
                .formatted(name, level);
    }

    private static double levelAt(MeasuredRun run, Command command, double time) {
        for (int k = 0; k < run.size(); k++) {
            if (Math.abs(run.time(k) - time) < 1e-9) {
                return command.level(k);
            }
        }
        throw new AssertionError("no sample at " + time);
    }

    @Test
    void forcesActUntilTheyAreReplacedOrRemoved() throws Exception {
        steps(5);
        sent(false, force(1));
        steps(5);
        sent(false, force(2));
        steps(5);
        sent(
                false,
                "<remove-force-command world-object-id=\"1\" force-name=\"pull\"/>"
                        + force(3).replace("pull", "other"));
        steps(5);

        MeasuredRun run = read().runs().getFirst();

        assertThat(run.forces())
                .extracting(f -> f.force().vector().x())
                .containsExactly(1.0, 2.0, 3.0);
        ScheduledForce second = run.forces().get(1);
        assertThat(second.from()).isCloseTo(1, within(1e-9));
        assertThat(second.until()).isCloseTo(1.5, within(1e-9));
        assertThat(second.force().frame()).isEqualTo(Frame.BODY);
        assertThat(run.forces().get(2).until()).isEqualTo(Double.MAX_VALUE);
    }

    private static String force(int newtons) {
        return ("<apply-direct-force-command world-object-id=\"1\" name=\"pull\""
                        + " orientation=\"BODY\"><force-vector x=\"%d\" y=\"0\" z=\"0\"/>"
                        + "</apply-direct-force-command>")
                .formatted(newtons);
    }

    @Test
    void northEastDownAndCovariancesBecomeTheWorlds() throws Exception {
        for (int i = 0; i < 20; i++) {
            step(
                    ("frame=\"NED\"><position x=\"%d\" y=\"2\" z=\"3\"/>"
                                    + "<orientation w=\"1\" x=\"0\" y=\"0\" z=\"0\"/>"
                                    + "<velocity x=\"4\" y=\"5\" z=\"6\"/>"
                                    + "<covariance>%s</covariance>")
                            .formatted(i, diagonal(4, 9, 16, 1, 1, 1, 1, 1, 1)));
        }

        MeasuredRun run = read().runs().getFirst();

        assertThat(run.vector(Channel.POSITION, 1)).contains(new Vec3(2, 1, -3));
        assertThat(run.deviation(Channel.POSITION, 1, 0)).isEqualTo(3);
        assertThat(run.deviation(Channel.POSITION, 1, 2)).isEqualTo(4);
        assertThat(run.vector(Channel.VELOCITY, 1)).contains(new Vec3(5, 4, -6));
        Quat north = run.orientation(1).orElseThrow();
        assertThat(north.rotate(new Vec3(1, 0, 0)).distance(new Vec3(0, 1, 0))).isLessThan(1e-12);
    }

    private static String diagonal(double... variances) {
        StringBuilder rows = new StringBuilder();
        for (int i = 0; i < variances.length; i++) {
            double[] row = new double[variances.length];
            row[i] = variances[i];
            rows.append("<row values=\"");
            for (double element : row) {
                rows.append(element).append(' ');
            }
            rows.append("\"/>");
        }
        return rows.toString();
    }

    @Test
    void whatIsRelativeToThatOfTheSimulatorIsLeftOut() throws Exception {
        for (int i = 0; i < 20; i++) {
            step(
                    "frame=\"BODY\"><position x=\"1\" y=\"2\" z=\"3\"/><velocity x=\"%d\" y=\"5\" z=\"6\"/>"
                            .formatted(i));
        }

        RunFile file = read();

        MeasuredRun run = file.runs().getFirst();
        assertThat(run.measures(Channel.POSITION)).isFalse();
        assertThat(run.frame(Channel.VELOCITY)).isEqualTo(Frame.BODY);
        assertThat(run.vector(Channel.VELOCITY, 3)).contains(new Vec3(3, 5, 6));
        assertThat(file.notices())
                .anyMatch(n -> n.contains("dive.auvsml: parts of 20 measurements"));
    }

    @Test
    void itEndsWhereTheWorldIsReplaced() throws Exception {
        steps(20);
        sent(false, "<reset-command/>");
        steps(20);

        RunFile file = read();

        assertThat(file.runs().getFirst().size()).isEqualTo(20);
        assertThat(file.notices())
                .containsExactly(
                        folder.resolve("dive.auvsml")
                                + ": at 2 s the world was replaced; what follows is left out");
    }

    @Test
    void withoutFeedbackItIsNoRun() {
        steps(3);

        assertThatThrownBy(this::read)
                .isInstanceOf(DocumentException.class)
                .hasMessageEndingWith(
                        "dive.auvsml: expected feedback for 'Rov' at 16 instants at least, but"
                                + " found 3");
    }

    @Test
    void theMeasuredBodyIsInIt() {
        int end = text.length();
        String other = text.toString().replace("name=\"Rov\"", "name=\"Auv\"");
        text.replace(0, end, other);
        steps(20);

        assertThatThrownBy(this::read)
                .hasMessageEndingWith(
                        "dive.auvsml: the recorded scenario has no world object 'Rov'");
    }
}
