package org.auvsim.cli;

import static org.assertj.core.api.Assertions.assertThat;

import org.auvsim.auvsml.client.AuvsmlClient;
import org.auvsim.auvsml.message.control.TakeControlCommand;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Locale;

/**
 * A ship that the model takes to go north at 1 m/s, while it was measured at 1.2 m/s, two samples a
 * step.
 */
@Timeout(60)
class FeedTest {
    private static final int STEPS = 20;

    @TempDir private Path folder;
    private CommandLineHarness auvsim;
    private Path log;

    @BeforeEach
    void measure() throws IOException {
        auvsim = new CommandLineHarness(folder);
        StringBuilder csv = new StringBuilder("time_s,north,east\n");
        for (int i = 1; i <= 2 * STEPS; i++) {
            csv.append(String.format(Locale.ROOT, "%.2f,%.4f,3%n", i * 0.05, 1.2 * i * 0.05));
        }
        log = auvsim.file("log.csv", csv.toString());
    }

    private Path ship(String feedbackTimestepper) throws IOException {
        return auvsim.file(
                "ship.xml",
                """
                <scenario>
                  <time-step delta="0.1"/>
                  %s
                  <world-object id="5" name="ship" mass="100">
                    <sphere radius="1"/>
                    <position x="3" y="0" z="0"/>
                    <velocity x="0" y="1" z="0"/>
                  </world-object>
                </scenario>
                """
                        .formatted(feedbackTimestepper));
    }

    private ServerProcess serve(String feedbackTimestepper) throws IOException {
        return new ServerProcess(
                ship(feedbackTimestepper), "--paused", "--rate", "max", "--until", "2");
    }

    private int feed(ServerProcess server, Object... more) {
        Object[] arguments = {
            "feed",
            log,
            server.address(),
            "--object",
            "ship",
            "--frame",
            "ned",
            "--resume",
            "--columns",
            "t=time_s,x=north,y=east"
        };
        Object[] all = new Object[arguments.length + more.length];
        System.arraycopy(arguments, 0, all, 0, arguments.length);
        System.arraycopy(more, 0, all, arguments.length, more.length);
        return auvsim.run(all);
    }

    /**
     * Each step waits for the answer: none can be late. In mid-step the ship that is moved after
     * each step is (1.2 - 1) m/s * 0.05 s behind; the one that is pushed to its place is not.
     */
    @ParameterizedTest
    @CsvSource({
        "DirectPositionChangeFeedbackHandler, 0.0100",
        "VectorAdjustmentFeedbackHandler, 0.0000"
    })
    void correctsTheSimulatedShip(String handler, String error) throws IOException {
        try (ServerProcess server =
                serve(
                        "<simple-fixed-time-feedback-timestepper wait='30'><client name='client"
                                + " 1'/></simple-fixed-time-feedback-timestepper>")) {
            assertThat(feed(server, "--every", 2, "--handler", handler)).isZero();
        }
        assertThat(auvsim.out())
                .startsWith("samples: 20 sent (20 applied, 0 refused), 20 held back\n")
                .contains(
                        "error: RMS %s m, largest %s m, at 19 samples held back\n"
                                .formatted(error, error))
                .doesNotContain("warning");
    }

    @Test
    void comparesOnlyWhenItSendsNothing() throws IOException {
        try (ServerProcess server =
                serve("<simple-fixed-time-feedback-timestepper wait='0.001'/>")) {
            assertThat(feed(server, "--every", 0)).isZero();
        }
        // 0.01 m i for i = 2 to 40: the root of (22140 - 1) / 39
        assertThat(auvsim.out())
                .startsWith("samples: 0 sent (0 applied, 0 refused), 40 held back\n")
                .contains("error: RMS 0.2383 m, largest 0.4000 m, at 39 samples held back\n");
    }

    @Test
    void aSimulatorThatUsesNoFeedbackIsTold() throws IOException {
        Path scenario = ship("<no-feedback-timestepper/>");
        try (ServerProcess server = new ServerProcess(scenario, "--paused")) {
            assertThat(feed(server, "--every", 1)).isEqualTo(2);
        }
        assertThat(auvsim.out()).contains("first refusal: ").contains("warning: ");
        assertThat(auvsim.err()).startsWith("None of the ").contains("uses no feedback");
    }

    @Test
    void aHandlerThatIsNotThereIsExplained() throws IOException {
        try (ServerProcess server =
                serve("<simple-fixed-time-feedback-timestepper wait=\"0.1\"/>")) {
            assertThat(feed(server, "--handler", "Nope")).isEqualTo(2);
        }
        assertThat(auvsim.out()).doesNotContain("longer wait");
        assertThat(auvsim.err()).contains("no feedback processor has the name 'Nope'");
    }

    @Test
    void aLogThatIsOverBeforeTheSimulatorsTimeIsRefused() throws IOException {
        Files.writeString(log, "time_s,north,east\n-2,0,0\n-1,1,0\n");
        try (ServerProcess server = new ServerProcess(ship(""), "--paused")) {
            assertThat(feed(server)).isEqualTo(2);
        }
        assertThat(auvsim.err())
                .isEqualTo(
                        "The simulator is at 0.0 s already, but the log ends at -1.0 s: start it"
                                + " with 'serve --paused' and feed with --resume.\n");
    }

    @Test
    void anObjectThatAnotherControlsIsNotFed() throws Exception {
        try (ServerProcess server =
                        serve("<simple-fixed-time-feedback-timestepper wait=\"0.1\"/>");
                var pilot = AuvsmlClient.connect("127.0.0.1", server.port())) {
            Question.ask(pilot, new TakeControlCommand(5));
            assertThat(feed(server)).isEqualTo(2);
        }
        assertThat(auvsim.err()).contains("controls 'ship' (id 5); wait until it lets go");
    }

    @Test
    void anUnknownObjectIsExplained() throws IOException {
        try (ServerProcess server = new ServerProcess(ship(""), "--paused")) {
            assertThat(
                            auvsim.run(
                                    "feed",
                                    log,
                                    server.address(),
                                    "--object",
                                    "boat",
                                    "--columns",
                                    "t=time_s,x=north,y=east"))
                    .isEqualTo(2);
        }
        assertThat(auvsim.err())
                .isEqualTo("There is no world object 'boat'; there is 'ship' (id 5).\n");
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "t=time_s,x=north | :1: there is no column 'y', only time_s, north, east; say with"
                        + " --columns which to take.",
                "t=time_s,x=north,y=east,z=down | :1: there is no column 'down', only time_s,"
                        + " north, east; say with --columns which to take.",
            })
    void missingColumnsAreExplained(String columns, String sentence) {
        assertThat(auvsim.run("feed", log, "--object", "ship", "--columns", columns)).isEqualTo(2);
        assertThat(auvsim.err()).isEqualTo(log + sentence + "\n");
    }

    @Test
    void wrongOptionsAreExplained() {
        assertThat(auvsim.run("feed", log, "--object", "ship", "--columns", "q=time_s"))
                .isEqualTo(2);
        assertThat(auvsim.run("feed", log, "--object", "ship", "--every", -1)).isEqualTo(2);
        assertThat(auvsim.run("feed", folder.resolve("none.csv"), "--object", "ship")).isEqualTo(2);
        assertThat(auvsim.err().lines())
                .containsExactly(
                        "--columns gives names to t, x, y and z, but not to 'q'.",
                        "--every must be 0 or more, but is -1.",
                        "Cannot read " + folder.resolve("none.csv") + ": there is no such file.");
    }
}
