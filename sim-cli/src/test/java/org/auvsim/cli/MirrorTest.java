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

/**
 * A ship that a simulator takes to go north at 1 m/s, and a mirror at 1.2 m/s, in steps of 0.1 s
 * and 0.03 s, over 2 s.
 */
@Timeout(60)
class MirrorTest {
    private static final String WAITS =
            "<simple-fixed-time-feedback-timestepper wait='30'><client name='client 1'/>"
                    + "</simple-fixed-time-feedback-timestepper>";

    @TempDir private Path folder;
    private CommandLineHarness auvsim;

    @BeforeEach
    void begin() {
        auvsim = new CommandLineHarness(folder);
    }

    private Path scenario(String file, String name, double step, double speed, String timestepper)
            throws IOException {
        return auvsim.file(
                file,
                """
                <scenario>
                  <time-step delta="%s"/>
                  %s
                  <world-object name="%s" mass="100">
                    <sphere radius="1"/>
                    <position x="3" y="0" z="0"/>
                    <velocity x="0" y="%s" z="0"/>
                  </world-object>
                  <world-object name="rock of %s" mass="1" fixed="1">
                    <sphere radius="1"/>
                    <position x="30" y="0" z="0"/>
                  </world-object>
                </scenario>
                """
                        .formatted(step, timestepper, name, speed, file));
    }

    private Path other(String name) throws IOException {
        return scenario("mirror.xml", name, 0.03, 1.2, "");
    }

    private ServerProcess serve(String timestepper) throws IOException {
        return new ServerProcess(
                scenario("served.xml", "ship", 0.1, 1, timestepper),
                "--paused",
                "--rate",
                "4",
                "--until",
                "2");
    }

    /** 0.02 m apart when the first step is projected; then the speed has been corrected, too. */
    @Test
    void correctsThePositionAndTheSpeed() throws IOException {
        try (ServerProcess server = serve(WAITS)) {
            assertThat(auvsim.run("mirror", other("ship"), server.address(), "--resume")).isZero();
        }
        assertThat(auvsim.err()).isEmpty();
        assertThat(auvsim.out().lines())
                .containsExactly(
                        "object   compared      rms (m)  largest (m)   at end (m)",
                        "ship           20     0.004472     0.020000     0.000000",
                        "corrections: 20 sent, 20 applied, 0 refused");
    }

    /** 0.02 m more in each step: the root of the mean of (0.02 i)^2 over i = 1 to 20. */
    @ParameterizedTest
    @ValueSource(
            strings = {
                "",
                "<simple-fixed-time-feedback-timestepper wait='0.001'/>",
                "<asynchronous-feedback-timestepper/>"
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
                        "object   compared      rms (m)  largest (m)   at end (m)",
                        "ship           20     0.239583     0.400000     0.400000");
        assertThat(Files.readAllLines(csv))
                .hasSize(21)
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
                                + " 'rock of mirror.xml', there 'ship', 'rock of served.xml'.\n");
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
