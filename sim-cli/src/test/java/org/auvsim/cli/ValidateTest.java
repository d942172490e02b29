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
    void documentsOfMeasuredRunsAreCheckedLikeScenarios() throws IOException {
        Path mapping =
                auvsim.file(
                        "map.xml",
                        "<column-mapping><column name=\"T\" means=\"t\" form=\"ISO-8601\"/>"
                                + "</column-mapping>");
        Path run = auvsim.file("run1.xml", "<run role=\"FIT\"/>");

        assertThat(auvsim.run("validate", mapping, run)).isZero();
        assertThat(auvsim.out()).isEqualTo(mapping + ": ok\n" + run + ": ok\n");
    }

    @Test
    void faultsOfDocumentsOfMeasuredRunsHaveTheirPlaces() throws IOException {
        Path mapping =
                auvsim.file(
                        "map.xml",
                        """
                        <column-mapping>
                          <column name="T" means="t" form="ISO"/>
                          <colum name="X"/>
                        </column-mapping>
                        """);
        Path run = auvsim.file("run1.xml", "<run role=\"JUDGE\"/>");

        assertThat(auvsim.run("validate", mapping, run)).isEqualTo(2);
        assertThat(auvsim.out())
                .contains(mapping + ":2:")
                .contains("expected one of NUMBER, HHMMSS, ISO-8601, but found 'ISO'")
                .contains(mapping + ":3:")
                .contains("'column'")
                .contains(run + ":1:")
                .contains("JUDGE");
    }

    /** Added mass as it is printed for the RexROV: it holds, but not to the letter. */
    @Test
    void whatDoesNotHoldToTheLetterIsNoticed() throws IOException {
        Path file =
                auvsim.file(
                        "a.xml",
                        """
                        <scenario>
                          <world-object name="Rover" mass="1863"><sphere radius="1"/>
                            <added-mass>
                              <linear x="779" y="1222" z="3660"/><angular x="534" y="842" z="224"/>
                              <term row="SWAY" column="ROLL" value="10.774"/>
                              <term row="ROLL" column="SWAY" value="10.775"/>
                            </added-mass>
                          </world-object>
                        </scenario>
                        """);
        String notice =
                file
                        + ": notice: 'Rover': an added mass matrix is symmetric, but ROLL by SWAY"
                        + " is 10.775 and SWAY by ROLL is 10.774; their mean counts\n";

        assertThat(auvsim.run("validate", file)).isZero();
        assertThat(auvsim.out()).isEqualTo(file + ": ok\n");
        assertThat(auvsim.err()).isEqualTo(notice);
        assertThat(auvsim.run("run", file, "--until", 0.1)).isZero();
        assertThat(auvsim.err()).startsWith(notice + notice);
    }

    @Test
    void aMissingFileIsExplained() {
        Path missing = folder.resolve("none.xml");
        assertThat(auvsim.run("validate", missing)).isEqualTo(2);
        assertThat(auvsim.err()).isEqualTo(missing + ": there is no such file\n");
    }
}
