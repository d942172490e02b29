package org.auvsim.cli;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import static java.nio.charset.StandardCharsets.UTF_8;

import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

import java.awt.image.BufferedImage;
import java.io.BufferedReader;
import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.atomic.AtomicLong;

import javax.imageio.ImageIO;

class RunTest {
    private static final String HEADER = "t,object,x,y,z,qw,qx,qy,qz,vx,vy,vz,wx,wy,wz";
    private static final Path SCENARIOS = CommandLineHarness.EXAMPLES.resolve("scenarios");

    @TempDir private Path folder;
    private CommandLineHarness auvsim;

    @BeforeEach
    void begin() {
        auvsim = new CommandLineHarness(folder);
    }

    /** Thesis, Figure 5.1: both move until they touch at (1 - 1/sqrt 2)/2 s. */
    @Test
    void writesEachObjectAtTheStartAndAfterEachStep() throws IOException {
        Path csv = folder.resolve("run.csv");

        assertThat(
                        auvsim.run(
                                "run",
                                SCENARIOS.resolve("crossing.xml"),
                                "--until",
                                0.2,
                                "--out",
                                csv))
                .isZero();

        List<String> lines = Files.readAllLines(csv, UTF_8);
        assertThat(lines.get(0)).isEqualTo(HEADER);
        assertThat(lines.get(1))
                .isEqualTo("0.0,A,-1.0,0.0,0.0,1.0,0.0,0.0,0.0,2.0,0.0,0.0,0.0,0.0,0.0");
        assertThat(lines.get(2))
                .isEqualTo("0.0,B,0.0,-1.0,0.0,1.0,0.0,0.0,0.0,0.0,2.0,0.0,0.0,0.0,0.0");
        double contact = (1 - Math.sqrt(0.5)) / 2;
        assertThat(number(lines.get(3), 0)).isCloseTo(contact, within(1e-9));
        assertThat(number(lines.get(3), 2)).isCloseTo(-1 + 2 * contact, within(1e-9));
        assertThat(auvsim.out())
                .contains("times real time; 1 collision, 1 event\n")
                .contains("rows written to " + csv);
        assertThat(auvsim.err()).isEmpty();
    }

    @Test
    void drawsAPictureOfPathsHeightsAndSpeeds() throws IOException {
        Path picture = folder.resolve("run.png");
        Path scenario = SCENARIOS.resolve("bluerov2-dive.xml");

        assertThat(auvsim.run("run", scenario, "--until", 20, "--plot", picture)).isZero();

        BufferedImage image = ImageIO.read(picture.toFile());
        assertThat(image.getHeight()).isGreaterThan(image.getWidth());
        assertThat(auvsim.out()).contains("picture written to " + picture);
        assertThat(auvsim.run("run", scenario, "--plot", folder.resolve("run.svg"))).isEqualTo(2);
        assertThat(auvsim.err()).contains("--plot draws PNG, so the file's name must end in .png");
        assertThat(auvsim.run("run", scenario, "--plot", folder.resolve("none/run.png")))
                .isEqualTo(2);
        assertThat(auvsim.out()).containsOnlyOnce(" steps: ");
    }

    @Test
    void onlyOneTableGoesToTheStandardOutput() {
        Path scenario = SCENARIOS.resolve("tank.xml");
        assertThat(auvsim.run("run", scenario, "--until", 0.1, "--readings", "-")).isZero();
        assertThat(auvsim.err()).contains("0 values read written to the standard output");
        assertThat(auvsim.run("run", scenario, "--out", "-", "--readings", "-")).isEqualTo(2);
        assertThat(auvsim.err()).contains("cannot both go to the standard output");
    }

    @Test
    void writesCsvAloneToTheStandardOutput() {
        assertThat(
                        auvsim.run(
                                "run",
                                SCENARIOS.resolve("crossing.xml"),
                                "--until",
                                0.1,
                                "--out",
                                "-"))
                .isZero();

        assertThat(auvsim.out().lines()).first().isEqualTo(HEADER);
        assertThat(auvsim.out().lines().skip(1))
                .isNotEmpty()
                .allMatch(l -> l.split(",").length == 15);
        assertThat(auvsim.err()).contains("of world time");
    }

    @Test
    void writesWhatSensorsRead() throws IOException {
        Path scenario = folder.resolve("diver.xml");
        Files.writeString(
                scenario,
                """
                <scenario>
                  <datum latitude="0" longitude="0"/>
                  <world-object name="Diver" mass="1">
                    <sphere radius="0.1"/>
                    <velocity x="0" y="0" z="-1"/>
                    <depth-sensor name="Keller"><sampling rate="40" delay="0.01"/></depth-sensor>
                    <range-sonar name="Echo" maximum-range="9"><sampling rate="5"/></range-sonar>
                  </world-object>
                  <world-object name="Wall" fixed="1">
                    <box><size x="2" y="20" z="20"/></box><position x="4" y="0" z="0"/>
                  </world-object>
                </scenario>
                """);
        Path csv = folder.resolve("readings.csv");

        assertThat(auvsim.run("run", scenario, "--until", 0.2, "--readings", csv)).isZero();

        List<String> lines = Files.readAllLines(csv, UTF_8);
        assertThat(lines.get(0)).isEqualTo("t,arrived,object,sensor,quantity,value");
        assertThat(lines.get(1)).isEqualTo("0.025,0.035,Diver,Keller,depth,0.025");
        assertThat(lines)
                .contains("0.2,0.2,Diver,Echo,echo.0.beam,0")
                .contains("0.2,0.2,Diver,Echo,echo.0.distance,3.0")
                .hasSize(1 + 7 + 2);
        assertThat(auvsim.out()).contains("9 values read written to " + csv);
    }

    @Test
    void leavesOutWhatIsFixed() {
        assertThat(auvsim.run("run", SCENARIOS.resolve("tank.xml"), "--until", 0.2, "--out", "-"))
                .isZero();
        assertThat(auvsim.out()).contains(",AUV-1701,").doesNotContain("Wall");
    }

    @ParameterizedTest
    @CsvSource({
        "-1, '--until must be after the scenario''s start at 0.0 s, but is -1.0 s.'",
        "soon, '--until: expected a number, but found ''soon''.'",
    })
    void wrongEndsAreExplained(String until, String sentence) {
        assertThat(auvsim.run("run", SCENARIOS.resolve("tank.xml"), "--until", until)).isEqualTo(2);
        assertThat(auvsim.err().lines()).first().isEqualTo(sentence);
    }

    @ParameterizedTest
    @ValueSource(strings = {"run", "serve"})
    void thereIsAtLeastOneLane(String command) {
        assertThat(auvsim.run(command, SCENARIOS.resolve("tank.xml"), "--lanes", 0)).isEqualTo(2);
        assertThat(auvsim.err()).isEqualTo("--lanes must be 1 to 256, but is 0.\n");
    }

    @Test
    void lanesChangeNothingInTheResult() {
        Path scenario = SCENARIOS.resolve("tank.xml");
        assertThat(auvsim.run("run", scenario, "--until", 2, "--out", "-")).isZero();
        String alone = auvsim.out();

        CommandLineHarness other = new CommandLineHarness(folder);
        assertThat(other.run("run", scenario, "--until", 2, "--out", "-", "--lanes", 2)).isZero();
        assertThat(other.out()).isEqualTo(alone);
    }

    @Test
    void aMissingScenarioIsExplained() {
        Path missing = folder.resolve("none.xml");
        assertThat(auvsim.run("run", missing)).isEqualTo(2);
        assertThat(auvsim.err()).isEqualTo(missing + ": there is no such file\n");
    }

    @Test
    void aWrongScenarioIsExplainedWithItsPlace() throws IOException {
        Path file =
                auvsim.file(
                        "a.xml",
                        "<scenario>\n  <world-object name='A' mass='-3'>"
                                + "<sphere radius='1'/></world-object>\n</scenario>");
        assertThat(auvsim.run("run", file)).isEqualTo(2);
        assertThat(auvsim.err()).startsWith(file + ":2:3: ").contains("-3.0 kg").hasLineCount(1);
    }

    @Test
    void allFaultsOfAScenarioAreToldAsValidateTellsThem() throws IOException {
        Path file =
                auvsim.file(
                        "a.xml",
                        """
                        <scenario>
                          <world-object name="A" mass="1"><sphere radius="0"/></world-object>
                          <world-object name="B" mass="one"><sphere radius="1"/></world-object>
                        </scenario>
                        """);
        CommandLineHarness other = new CommandLineHarness(folder);
        assertThat(other.run("validate", file)).isEqualTo(2);

        assertThat(auvsim.run("run", file)).isEqualTo(2);

        assertThat(auvsim.err()).isEqualTo(other.out()).hasLineCount(2);
    }

    @Test
    void aFolderThatIsMissingIsExplained() {
        Path csv = folder.resolve("none").resolve("run.csv");
        assertThat(auvsim.run("run", SCENARIOS.resolve("tank.xml"), "--out", csv)).isEqualTo(2);
        assertThat(auvsim.err())
                .isEqualTo("Cannot write " + csv + ": its folder does not exist.\n");
    }

    @Test
    void aStepThatCannotBeMadeIsExplained() throws IOException {
        Path file =
                auvsim.file(
                        "fast.xml",
                        """
                        <scenario>
                          <snapshot-stepper><maximum-speed-restricter speed="1"/></snapshot-stepper>
                          <world-object name="Bolt" mass="1"><sphere radius="1"/>
                            <velocity x="2" y="0" z="0"/></world-object>
                        </scenario>
                        """);
        assertThat(auvsim.run("run", file)).isEqualTo(2);
        assertThat(auvsim.err())
                .startsWith("The run ends at 0.0 s: ")
                .contains("Bolt")
                .hasLineCount(1);
    }

    /** Its velocity grows past all numbers in a few steps; of shorter ones more can be made. */
    @Test
    void theLastGoodStateIsWrittenAndRunsOn() throws IOException {
        Path file =
                auvsim.file(
                        "wild.xml",
                        """
                        <scenario>
                          <time-step delta="1"/>
                          <world-object id="4" name="Bolt" mass="1e-3"><sphere radius="1"/>
                            <gravity acceleration="1e307"/></world-object>
                        </scenario>
                        """);
        Path last = folder.resolve("last.xml");
        Path before = folder.resolve("before.csv");
        Path after = folder.resolve("after.csv");

        assertThat(auvsim.run("run", file, "--last-good", last, "--out", before)).isEqualTo(2);

        assertThat(auvsim.err())
                .startsWith("The run ends at ")
                .contains("'Bolt' (id 4) gets out of all bounds between ")
                .contains(" s by its effect 'gravity', the largest of its forces; ")
                .endsWith("; the last good state is in " + last + "\n")
                .hasLineCount(1);
        CommandLineHarness again = new CommandLineHarness(folder);
        assertThat(again.run("validate", last)).isZero();
        String written = Files.readString(last, UTF_8);
        assertThat(written).contains("<world-object id=\"4\" name=\"Bolt\"", "<gravity ");
        double began =
                Double.parseDouble(written.replaceFirst("(?s).*start-time=\"([^\"]*)\".*", "$1"));
        assertThat(auvsim.err()).startsWith("The run ends at " + began + " s");

        Files.writeString(last, written.replaceFirst("delta=\"[^\"]*\"", "delta=\"0.01\""));
        assertThat(again.run("run", last, "--until", began + 0.02, "--out", after)).isZero();
        List<String> rows = Files.readAllLines(after, UTF_8);
        assertThat(rows).hasSize(1 + 3).element(1).isEqualTo(Files.readAllLines(before).getLast());
    }

    @Test
    void progressIsToldEveryTwoSecondsAndNotBefore() {
        StringWriter text = new StringWriter();
        AtomicLong nanos = new AtomicLong(5_000_000_000L);
        Progress progress = new Progress(10, 110, new PrintWriter(text), nanos::get);

        progress.at(11);
        nanos.addAndGet(1_900_000_000L);
        progress.at(20);
        assertThat(text.toString()).isEmpty();
        nanos.addAndGet(100_000_000L);
        progress.at(30);
        progress.at(31);

        assertThat(text.toString().lines())
                .containsExactly("at 30.0 s of 110.0 s (20 %), 10.0 times real time");
    }

    /** What Ctrl-C does is asked of a process of its own. */
    @Test
    @Timeout(60)
    void anInterruptedRunLeavesAWholeCsv() throws Exception {
        Path csv = folder.resolve("run.csv");
        List<String> command = OwnProcess.java();
        command.addAll(
                List.of(
                        Auvsim.class.getName(),
                        "run",
                        SCENARIOS.resolve("back-and-forth.xml").toString(),
                        "--until",
                        "1e9",
                        "--out",
                        csv.toString()));
        Process process = new ProcessBuilder(command).start();
        try (BufferedReader progress = process.errorReader(UTF_8)) {
            assertThat(progress.readLine()).startsWith("at ");
            process.toHandle().destroy(); // and leave its output open
            process.waitFor();
        }
        String text = Files.readString(csv, UTF_8);
        assertThat(text).endsWith("\n");
        assertThat(text.lines()).allMatch(line -> line.split(",").length == 15);
        long rows = text.lines().count() - 1;
        assertThat(process.inputReader(UTF_8).readAllAsString()).contains(rows + " rows written");
    }

    private static double number(String line, int column) {
        return Double.parseDouble(List.of(line.split(",")).get(column));
    }
}
