package org.auvsim.cli;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;

@Timeout(60)
class WatchTest {
    private static final Path TANK =
            CommandLineHarness.EXAMPLES.resolve("scenarios").resolve("tank.xml");

    /** It rests: a pair held in each step. */
    private static final String BOX_ON_THE_FLOOR =
            """
            <scenario>
              <world-object name="Floor" fixed="1"><half-space/></world-object>
              <world-object name="Box" mass="1" restitution="0.5">
                <box><size x="1" y="1" z="1"/></box>
                <position x="0" y="0" z="0.5"/>
                <gravity/>
              </world-object>
            </scenario>
            """;

    @TempDir private Path folder;
    private CommandLineHarness auvsim;

    @BeforeEach
    void begin() {
        auvsim = new CommandLineHarness(folder);
    }

    @Test
    void showsMovementsUntilTheServerEnds() throws Exception {
        try (ServerProcess server = new ServerProcess(TANK, "--until", "2")) {
            assertThat(auvsim.run("watch", server.address(), "--object", "AUV-1701")).isZero();
        }
        assertThat(auvsim.out().lines().toList())
                .first()
                .isEqualTo(EventLines.HEADER)
                .satisfies(_ -> assertThat(auvsim.out()).contains("the simulator ends: "));
        assertThat(auvsim.out().lines().filter(line -> line.contains("AUV-1701")))
                .anyMatch(line -> line.contains(" projected ") && line.contains("-6.0000"))
                .anyMatch(line -> line.contains(" actual "));
        assertThat(auvsim.out()).doesNotContain("Ball  ");
    }

    @ParameterizedTest(name = "object {0}")
    @ValueSource(strings = {"*", "Box"})
    void tellsWhatHeldAStepTogetherIfAsked(String object) throws Exception {
        Path scenario = Files.writeString(folder.resolve("box.xml"), BOX_ON_THE_FLOOR);
        List<String> command = new ArrayList<>(List.of("watch", "--steps"));
        if (!object.equals("*")) {
            command.addAll(List.of("--object", object));
        }
        try (ServerProcess server = new ServerProcess(scenario, "--until", "2")) {
            command.add(server.address());
            assertThat(auvsim.run(command.toArray())).isZero();
        }
        assertThat(auvsim.out().lines())
                .anyMatch(
                        line ->
                                line.matches(
                                        " +0\\.[0-9]{3}  \\(step\\) +sub-steps 0, contacts held 1,"
                                                + " quick hits 0, crowded hits 0, lowered hits 0,"
                                                + " islands unsolved 0"));
    }

    @Test
    void keepsStepsToItselfIfNotAsked() throws Exception {
        Path scenario = Files.writeString(folder.resolve("box.xml"), BOX_ON_THE_FLOOR);
        try (ServerProcess server = new ServerProcess(scenario, "--until", "2")) {
            assertThat(auvsim.run("watch", server.address())).isZero();
        }
        assertThat(auvsim.out()).contains("Box ").doesNotContain("(step)");
    }

    @Test
    void printsXmlAsItComes() throws Exception {
        try (ServerProcess server = new ServerProcess(TANK, "--until", "2")) {
            assertThat(auvsim.run("watch", server.address(), "--xml", "--object", "1")).isZero();
        }
        assertThat(auvsim.out())
                .contains("<movement-state-change-message ")
                .contains("state-type=\"ACTUAL\"");
        assertThat(auvsim.out().lines())
                .allMatch(line -> line.startsWith("<auvsml") && line.endsWith("</auvsml>"));
    }

    @Test
    void anUnknownObjectIsExplainedWithTheKnownOnes() throws Exception {
        try (ServerProcess server = new ServerProcess(TANK)) {
            assertThat(auvsim.run("watch", server.address(), "--object", "Nessie")).isEqualTo(2);
        }
        assertThat(auvsim.err())
                .startsWith("There is no world object 'Nessie'; there is 'AUV-1701' (id 1), ")
                .contains("'West Wall' (id 16).")
                .hasLineCount(1);
    }

    @ParameterizedTest
    @CsvSource({
        "127.0.0.1:1, Nobody listens at 127.0.0.1:1",
        "no-host.invalid:40001, There is no host 'no-host.invalid'"
    })
    void aServerThatIsNotThereIsExplained(String address, String sentence) {
        assertThat(auvsim.run("watch", address)).isEqualTo(2);
        assertThat(auvsim.err()).startsWith(sentence).hasLineCount(1);
    }

    @ParameterizedTest
    @ValueSource(strings = {"host:port", "a:b:c", "[::1"})
    void anAddressThatIsNoneIsExplained(String address) {
        assertThat(auvsim.run("watch", address)).isEqualTo(2);
        assertThat(auvsim.err()).contains("expected host:port").contains(address);
    }

    @ParameterizedTest
    @ValueSource(strings = {"host:99999", "host:0", ":123456789"})
    void aPortThatIsNoneIsExplained(String address) {
        assertThat(auvsim.run("watch", address)).isEqualTo(2);
        assertThat(auvsim.err()).contains("a port is a number from 1 to 65535").contains(address);
    }

    @ParameterizedTest
    @CsvSource({
        "host:1, host, 1",
        "host, host, 40001",
        ":7, 127.0.0.1, 7",
        "[::1]:9, [::1], 9",
        "10.0.0.1:40002, 10.0.0.1, 40002"
    })
    void addressesMayLeaveOutAPart(String text, String host, int port) {
        assertThat(new Address.Converter().convert(text)).isEqualTo(new Address(host, port));
    }
}
