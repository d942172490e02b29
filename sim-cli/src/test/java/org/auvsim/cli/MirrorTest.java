package org.auvsim.cli;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;

/**
 * Two ships that a simulator takes to go north at 1 m/s, and a mirror at 1.2 m/s, in steps of 0.1 s
 * and 0.03 s, over 2 s.
 */
@Timeout(60)
class MirrorTest {
    private static final String WAITS =
            "<simple-fixed-time-feedback-timestepper wait='30'><client name='client 1'/>"
                    + "</simple-fixed-time-feedback-timestepper>";

    private static final String LOCKSTEP = "<lockstep-timestepper/>";

    @TempDir private Path folder;
    private CommandLineHarness auvsim;

    @BeforeEach
    void begin() {
        auvsim = new CommandLineHarness(folder);
    }

    private Path scenario(
            String file, double horizon, String name, double step, double speed, String timestepper)
            throws IOException {
        return auvsim.file(
                file,
                """
                <scenario feedback-horizon="%s">
                  <time-step delta="%s"/>
                  %s
                  <world-object name="%s" mass="100">
                    <sphere radius="1"/>
                    <position x="3" y="0" z="0"/>
                    <velocity x="0" y="%s" z="0"/>
                  </world-object>
                  <world-object name="other %s" mass="100">
                    <sphere radius="1"/>
                    <position x="-3" y="0" z="0"/>
                    <velocity x="0" y="%s" z="0"/>
                  </world-object>
                  <world-object name="rock of %s" mass="1" fixed="1">
                    <sphere radius="1"/>
                    <position x="30" y="0" z="0"/>
                  </world-object>
                </scenario>
                """
                        .formatted(horizon, step, timestepper, name, speed, name, speed, file));
    }

    private Path other(String name) throws IOException {
        return scenario("mirror.xml", 0, name, 0.03, 1.2, "");
    }

    private ServerProcess serve(String timestepper) throws IOException {
        return serve(timestepper, 0);
    }

    private ServerProcess serve(String timestepper, double horizon) throws IOException {
        return new ServerProcess(
                scenario("served.xml", horizon, "ship", 0.1, 1, timestepper),
                "--paused",
                "--rate",
                "4",
                "--until",
                "2");
    }

    /** 0.02 m apart when the first step is projected; then the speed has been corrected, too. */
    @ParameterizedTest
    @ValueSource(strings = {WAITS, LOCKSTEP})
    void correctsThePositionAndTheSpeed(String timestepper) throws IOException {
        try (ServerProcess server = serve(timestepper)) {
            assertThat(auvsim.run("mirror", other("ship"), server.address(), "--resume")).isZero();
        }
        assertThat(auvsim.err()).isEmpty();
        assertThat(auvsim.out().lines())
                .containsExactly(
                        "object       compared      rms (m)  largest (m)   at end (m)",
                        "ship               20     0.004472     0.020000     0.000000",
                        "other ship         20     0.004472     0.020000     0.000000",
                        "corrections: 40 sent, 40 applied, 0 refused");
    }

    @Test
    void aProcessorThatTheSimulatorDoesNotHaveEndsIt() throws IOException {
        try (ServerProcess server = serve(WAITS)) {
            assertThat(
                            auvsim.run(
                                    "mirror",
                                    other("ship"),
                                    server.address(),
                                    "--processor",
                                    "Foo",
                                    "--resume"))
                    .isEqualTo(2);
        }
        assertThat(auvsim.err()).contains("no feedback processor has the name 'Foo'; there are ");
    }

    /**
     * Its answers come after the step, so that the past is made again with them and the present is
     * told twice.
     */
    @ParameterizedTest
    @ValueSource(doubles = {0, 5})
    void comparesAndAnswersATimeOnce(double horizon) throws IOException {
        Path csv = folder.resolve("apart.csv");
        try (ServerProcess server = serve("<asynchronous-feedback-timestepper/>", horizon)) {
            assertThat(
                            auvsim.run(
                                    "mirror",
                                    other("ship"),
                                    server.address(),
                                    "--csv",
                                    csv,
                                    "--resume"))
                    .isZero();
        }
        assertThat(
                        Files.readAllLines(csv).stream()
                                .skip(1)
                                .map(row -> row.substring(0, row.indexOf(','))))
                .hasSize(40)
                .isSortedAccordingTo(Comparator.comparingDouble(Double::parseDouble));
        assertThat(auvsim.out())
                .containsPattern("\nship +20 ")
                .containsPattern("\nother ship +20 ");
    }

    /** The server is cut off after it has told of some steps, as if its process were killed. */
    @ParameterizedTest
    @ValueSource(booleans = {false, true})
    void aConnectionThatBreaksIsToldAfterTheTable(boolean observe) throws Exception {
        try (ServerProcess server = serve(LOCKSTEP);
                BrokenLine line = new BrokenLine(server.port(), "timestamp=\"1.0")) {
            List<Object> arguments =
                    new ArrayList<>(List.of("mirror", other("ship"), line.address(), "--resume"));
            if (observe) {
                arguments.add("--observe");
            }
            assertThat(auvsim.run(arguments.toArray())).isEqualTo(2);
            assertThat(auvsim.err())
                    .startsWith("The connection to " + line.address() + " broke at ")
                    .hasLineCount(1);
        }
        assertThat(auvsim.out()).startsWith("object ").containsPattern("\nship +[0-9]+ ");
    }

    /** 0.02 m more in each step: the root of the mean of (0.02 i)^2 over i = 1 to 20. */
    @ParameterizedTest
    @ValueSource(
            strings = {
                "",
                "<simple-fixed-time-feedback-timestepper wait='0.001'/>",
                "<asynchronous-feedback-timestepper/>",
                LOCKSTEP
            })
    void observesWithoutCorrecting(String timestepper) throws IOException {
        Path csv = folder.resolve("apart.csv");
        try (ServerProcess server = serve(timestepper)) {
            assertThat(
                            auvsim.run(
                                    "mirror",
                                    other("ship"),
                                    server.address(),
                                    "--observe",
                                    "--csv",
                                    csv,
                                    "--resume"))
                    .isZero();
        }
        assertThat(auvsim.out().lines())
                .containsExactly(
                        "object       compared      rms (m)  largest (m)   at end (m)",
                        "ship               20     0.239583     0.400000     0.400000",
                        "other ship         20     0.239583     0.400000     0.400000");
        assertThat(Files.readAllLines(csv))
                .hasSize(41)
                .first()
                .isEqualTo(
                        "time_s,object,served_x_m,served_y_m,served_z_m,mirrored_x_m,"
                                + "mirrored_y_m,mirrored_z_m,distance_m");
    }

    @Test
    void objectsOfOtherNamesAreExplained() throws IOException {
        Path mirror = other("boat");
        try (ServerProcess server = serve("")) {
            assertThat(auvsim.run("mirror", mirror, server.address())).isEqualTo(2);
        }
        assertThat(auvsim.err())
                .isEqualTo(
                        mirror
                                + " and the simulator have no object of one name: here 'boat',"
                                + " 'other boat', 'rock of mirror.xml', there 'ship', 'other"
                                + " ship', 'rock of served.xml'.\n");
    }

    @Test
    void aSimulatorThatUsesNoFeedbackIsTold() throws IOException {
        try (ServerProcess server = serve("<no-feedback-timestepper/>")) {
            assertThat(auvsim.run("mirror", other("ship"), server.address(), "--resume"))
                    .isEqualTo(2);
        }
        assertThat(auvsim.out()).contains("first refusal: ").contains("uses no feedback");
        assertThat(auvsim.err()).endsWith("corrections was applied.\n");
    }

    @Test
    void aServerThatIsNotThereIsExplained() throws IOException {
        assertThat(auvsim.run("mirror", other("ship"), "127.0.0.1:1")).isEqualTo(2);
        assertThat(auvsim.err()).startsWith("Nobody listens at 127.0.0.1:1");
    }
}
