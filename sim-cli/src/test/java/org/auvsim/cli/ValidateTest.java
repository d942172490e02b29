package org.auvsim.cli;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

import java.io.IOException;
import java.nio.file.Path;

class ValidateTest {
    @TempDir private Path folder;
    private CommandLineHarness auvsim;

    @BeforeEach
    void begin() {
        auvsim = new CommandLineHarness(folder);
    }

    @Test
    void scenariosAndMessagesThatAreRight() throws IOException {
        Path scenario = CommandLineHarness.EXAMPLES.resolve("scenarios").resolve("tank.xml");
        Path messages =
                auvsim.file(
                        "a.xml",
                        "<auvsml><pause-simulator-command/></auvsml>\n<auvsml>"
                                + "<resume-simulator-command/></auvsml>");

        assertThat(auvsim.run("validate", scenario, messages)).isZero();
        assertThat(auvsim.out()).isEqualTo(scenario + ": ok\n" + messages + ": ok\n");
    }

    @Test
    void everyFaultHasItsPlace() throws IOException {
        Path file =
                auvsim.file(
                        "a.xml",
                        """
                        <scenario>
                          <world-object name="A" mass="heavy"><sphere radius="1"/></world-object>
                          <wold-object name="B" mass="1"><sphere radius="1"/></wold-object>
                        </scenario>
                        """);

        assertThat(auvsim.run("validate", file)).isEqualTo(2);
        assertThat(auvsim.out().lines())
                .hasSize(2)
                .allMatch(line -> line.matches("\\Q" + file + "\\E:[0-9]+:[0-9]+: .+"));
        assertThat(auvsim.out())
                .contains(file + ":2:")
                .contains("heavy")
                .contains(file + ":3:")
                .contains("'world-object'");
    }

    @Test
    void aMissingFileIsExplained() {
        Path missing = folder.resolve("none.xml");
        assertThat(auvsim.run("validate", missing)).isEqualTo(2);
        assertThat(auvsim.err()).isEqualTo(missing + ": there is no such file\n");
    }
}
