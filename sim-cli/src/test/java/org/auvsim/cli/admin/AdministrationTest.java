package org.auvsim.cli.admin;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import org.auvsim.auvsml.client.AuvsmlClient;
import org.auvsim.auvsml.mapping.MessageCatalogue;
import org.auvsim.cli.report.UserError;
import org.auvsim.core.actuator.Propulsor;
import org.auvsim.core.entity.WorldObjectDefinition;
import org.auvsim.core.math.Vec3;
import org.auvsim.core.volume.Sphere;
import org.auvsim.core.world.World;
import org.auvsim.server.net.TcpTransport;
import org.auvsim.server.simulator.Simulator;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

import java.io.BufferedReader;
import java.io.PrintWriter;
import java.io.StringReader;
import java.io.StringWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.stream.Collectors;
import java.util.stream.IntStream;

/** Lines from a pipe, to a simulator over a real socket. */
@Timeout(60)
class AdministrationTest {
    private final TcpTransport tcp = TcpTransport.onLoopback(0);
    private final MessageCatalogue catalogue =
            MessageCatalogue.load(AdministrationTest.class.getClassLoader());
    private Simulator simulator = Simulator.of(world()).transport(tcp).paused().start();

    private static World world() {
        return World.builder()
                .add(
                        WorldObjectDefinition.named("Red Fish")
                                .id(7)
                                .mass(2)
                                .volume(new Sphere(1))
                                .component(
                                        new Propulsor("Tail", 10, 0, Vec3.ZERO, new Vec3(1, 0, 0)))
                                .build())
                .build();
    }

    @BeforeEach
    void begin() {
        assertThat(simulator.state().running()).isFalse();
    }

    @AfterEach
    void end() {
        simulator.close();
    }

    /** What is printed for these lines. */
    private String perform(String... lines) throws Exception {
        StringWriter out = new StringWriter();
        try (AuvsmlClient client = AuvsmlClient.connect("127.0.0.1", tcp.port(), catalogue)) {
            new Administration(client, catalogue)
                    .perform(
                            new BufferedReader(new StringReader(String.join("\n", lines))),
                            new PrintWriter(out));
        }
        return out.toString().replace(System.lineSeparator(), "\n");
    }

    @Test
    void plainWordsAreCommandsAndAnswersPlainText() throws Exception {
        assertThat(perform("# how does it stand?", "", "set rate 2.5", "state"))
                .isEqualTo(
                        "done\n"
                                + "simulator state: time 0.0, running no, rate 2.5, step 0, clients"
                                + " 1\n");
        assertThat(perform("list world objects"))
                .isEqualTo("id  type         name\n7   WorldObject  Red Fish\n");
    }

    @ParameterizedTest
    @CsvSource({"resume", "resume-simulator", "resume-simulator-command"})
    void aCommandMayBeSaidInSeveralWays(String words) throws Exception {
        if (words.equals("resume-simulator")) {
            assertThatThrownBy(() -> perform(words)).hasMessageContaining("no command");
        } else {
            assertThat(perform(words)).isEqualTo("done\n");
            assertThat(simulator.state().running()).isTrue();
        }
    }

    @Test
    void valuesStandInOrderOrByNameAndNamesForIds() throws Exception {
        perform("set propulsor \"Red Fish\" Tail 0.5");
        assertThat(level()).isEqualTo(0.5);
        perform("set propulsor level=-1 name=Tail world-object-id=7");
        assertThat(level()).isEqualTo(-1);
    }

    private double level() {
        return simulator.ask(
                world -> world.object(7).component(Propulsor.class).orElseThrow().command());
    }

    @Test
    void whatIsTooLongForASimulatorIsNotSent(@TempDir Path folder) throws Exception {
        String ball = "<world-object name=\"%d\" mass=\"1\"><sphere radius=\"1\"/></world-object>";
        String balls =
                IntStream.range(0, 1000).mapToObj(ball::formatted).collect(Collectors.joining());
        Path file = folder.resolve("balls.xml");
        Files.writeString(file, "<scenario>" + balls + "</scenario>");

        assertThatThrownBy(() -> perform("load scenario @" + file))
                .isInstanceOf(UserError.class)
                .hasMessageContaining("not sent: a simulator takes at most 65536 bytes at once");
    }

    @Test
    void elementsAreWrittenAsTheyAreOrComeFromAFile(@TempDir Path folder) throws Exception {
        Path file =
                Files.writeString(
                        folder.resolve("weight.xml"),
                        "<?xml version=\"1.0\"?>\n<gravity acceleration=\"2\"/>\n");
        assertThat(
                        perform(
                                "add effect 7 <gravity acceleration=\"1\"/>",
                                "add-effect 7 @" + file,
                                "list effects 7"))
                .isEqualTo(
                        """
                        done
                        done
                        <effect-list-response world-object-id="7">
                          <gravity acceleration="1.0"/>
                          <gravity acceleration="2.0"/>
                        </effect-list-response>
                        """);
    }

    @Test
    void aWorldObjectIsDescribedAsAScenarioWouldStateIt() throws Exception {
        assertThat(perform("set propulsor 7 Tail 0.5", "describe world object \"Red Fish\""))
                .isEqualTo(
                        """
                        done
                        <world-object-description-response>
                          <world-object id="7" name="Red Fish" fixed="0" mass="2.0" restitution="1.0" friction="0.0" layer="0">
                            <sphere radius="1.0"/>
                            <position x="0.0" y="0.0" z="0.0"/>
                            <orientation w="1.0" x="0.0" y="0.0" z="0.0"/>
                            <velocity x="0.0" y="0.0" z="0.0"/>
                            <angular-velocity x="0.0" y="0.0" z="0.0"/>
                            <propulsor name="Tail" maximum-thrust="10.0" level="0.5" lag="0.0" dead-zone="0.0" reaction-torque="0.0" advance-loss="0.0">
                              <position x="0.0" y="0.0" z="0.0"/>
                              <direction x="1.0" y="0.0" z="0.0"/>
                            </propulsor>
                          </world-object>
                        </world-object-description-response>
                        """);
        assertThat(perform("help describe world object"))
                .startsWith("describe world object OBJECT\n\nAsks for a world object as it is now");
    }

    @Test
    void auvsmlIsTakenAsItIs() throws Exception {
        assertThat(
                        perform(
                                "<get-propulsor-list-request agent-id=\"7\"/>",
                                "<auvsml><step-command/></auvsml> <auvsml><get-field-list-request/>"
                                        + "</auvsml>"))
                .isEqualTo("name\nTail\ndone\n<field-list-response/>\n");
    }

    @Test
    void shutdownEndsTheSimulation() throws Exception {
        assertThat(perform("shutdown")).contains("done\n");
        simulator.await();
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "fly | There is no command 'fly'; 'help' lists all.",
                "set | There is no command 'set'; there is 'set ",
                "set rate fast | rate must be a number above 0, or 'max', but is 'fast'",
                "set propulsor 7 Tail fast | level: expected a finite number, but found 'fast'",
                "set propulsor 7 | Something is missing: set propulsor OBJECT NAME LEVEL",
                "add effect 7 | Something is missing: add effect OBJECT <effect>",
                "resmue | There is no command 'resmue'; the nearest is 'resume', and",
                "lst efects 7 | There is no command 'lst efects 7'; the nearest is 'list effects'",
                "set rate 1 2 | '2' is one word too many: set rate RATE",
                "take control Bob | There is no world object 'Bob'; there is [Red Fish].",
                "remove entity 99 | refused: no entity has the id 99",
                "add effect 7 @none.xml | Cannot read none.xml: there is no such file.",
                "add effect 7 <gravty/> | unknown element 'gravty'; the nearest known name is",
                "help fly | There is no command 'fly'; 'help' lists all.",
                "take control \"Bob | A quotation does not end: close it with \".",
            })
    void theFirstFaultEndsItWithItsLine(String line, String sentence) throws Exception {
        assertThatThrownBy(() -> perform("state", line, "shutdown"))
                .isInstanceOf(UserError.class)
                .hasMessageStartingWith("line 2: " + sentence)
                .hasMessageNotContaining("set-rate-command")
                .hasMessageNotContaining("set-propulsor-command");
        assertThat(simulator.state().step()).isZero();
    }

    @Test
    void helpListsAllCommandsAndExplainsEach() throws Exception {
        assertThat(perform("help"))
                .contains("add effect                     Lets an effect, described as in")
                .contains("\npause                          Lets the simulation stand still")
                .contains("help COMMAND tells more.");
        assertThat(perform("help set rate"))
                .startsWith("set rate RATE\n\nSets how fast the world's time goes.\n")
                .contains("\n  rate  a text  world seconds a second, above 0, or max")
                .contains("<set-rate-command rate=\"2.5\"/>")
                .doesNotContain("`")
                .doesNotContain("|");
        assertThat(perform("help list")).contains("list effects").doesNotContain("add effect");
    }

    @Test
    void exitLeavesTheSimulationAsItIs() throws Exception {
        assertThat(perform("exit", "shutdown")).isEmpty();
        assertThat(simulator.state().running()).isFalse();
    }
}
