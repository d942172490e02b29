package org.auvsim.server;

import static org.assertj.core.api.Assertions.assertThat;

import org.auvsim.server.net.TcpTransport;
import org.auvsim.server.simulator.Simulator;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;

/** What administrators do to a simulation that others listen to, over real sockets. */
@Timeout(60)
class AdministrationConversationTest {
    private static final String PUSH =
            "<apply-direct-force-command world-object-id=\"1\" name=\"push\" orientation=\"WORLD\">"
                    + "<force-vector x=\"2\" y=\"0\" z=\"0\"/></apply-direct-force-command>";
    private static final String OTHER_WORLD =
            "<load-scenario-command><scenario start-time=\"5\">"
                    + "<world-object id=\"1\" name=\"Whale\" mass=\"9\"><sphere radius=\"3\"/>"
                    + "<position x=\"8\" y=\"0\" z=\"0\"/></world-object></scenario>"
                    + "</load-scenario-command>";

    private final TcpTransport tcp = TcpTransport.onLoopback(0);
    private final Simulator simulator = Simulator.of(Tank.world()).transport(tcp).paused().start();
    private final List<RawClient> clients = new ArrayList<>();
    private RawClient admin;

    @BeforeEach
    void begin() throws IOException {
        admin = client();
    }

    @AfterEach
    void end() throws IOException {
        for (RawClient client : clients) {
            client.close();
        }
        simulator.close();
    }

    private RawClient client() throws IOException {
        RawClient client = RawClient.welcomed(tcp.port());
        clients.add(client);
        return client;
    }

    private RawClient listener(String event) throws IOException {
        RawClient client = client();
        client.ask(
                "listen",
                "<listener-registration-request-command register=\"1\"><world-object id=\"*\">"
                        + "<listener type=\"%s\"/></world-object></listener-registration-request-command>"
                                .formatted(event));
        return client;
    }

    /** Makes steps at once. */
    private void step(int count) {
        for (int i = 0; i < count; i++) {
            simulator.advanceTimestep();
        }
    }

    private double x() {
        return simulator.ask(world -> world.object(1).position().x());
    }

    private double time() {
        return simulator.ask(world -> world.time());
    }

    private void done(String message) throws IOException {
        assertThat(admin.ask("done", message)).contains("<command-done-response/>");
    }

    @Test
    void timeGoesBackToASnapshotAndOnFromThereAsBefore() throws IOException {
        done(PUSH);
        step(3);
        done("<take-snapshot-command name=\"early\"/>");
        double then = x();
        step(4);
        long later = simulator.ask(world -> world.stateHash());
        RawClient listener = listener("MovementStateChange");
        done("<restore-snapshot-command name=\"early\"/>");
        assertThat(x()).isEqualTo(then).isPositive();
        assertThat(listener.next("snapshot-restored-notification"))
                .contains("revision=\"1\" timestamp=\"0.15")
                .contains("name=\"early\"");
        assertThat(RawClient.number(listener.next(), "position", "x")).isEqualTo(then);
        step(4);
        assertThat(simulator.<Long>ask(world -> world.stateHash())).isEqualTo(later);
    }

    @Test
    void aSnapshotHoldsWhoControlsWhatAndWhatIsThere() throws IOException {
        done("<take-snapshot-command name=\"all\"/>");
        done(PUSH);
        done("<remove-entity-command entity-id=\"2\"/>");
        admin.ask(
                "rock",
                "<add-world-object-command><world-object name=\"Rock\" mass=\"3\">"
                        + "<sphere radius=\"1\"/><position x=\"50\" y=\"0\" z=\"0\"/>"
                        + "</world-object></add-world-object-command>");
        RawClient listener = listener("*ALL*");
        done("<restore-snapshot-command name=\"all\"/>");
        listener.next("snapshot-restored-notification");
        assertThat(listener.next("entity-removed-message")).contains("entity-id=\"5\"");
        assertThat(listener.next("entity-added-message")).contains("entity-id=\"2\"");
        assertThat(listener.ask("mine", PUSH)).contains("<command-done-response/>");
    }

    @Test
    void snapshotsAreListed() throws IOException {
        assertThat(admin.ask("1", "<list-snapshots-request/>"))
                .contains("<snapshot-list-response/>");
        done("<take-snapshot-command name=\"a\"/>");
        step(1);
        done("<take-snapshot-command name=\"b\"/>");
        assertThat(admin.ask("2", "<list-snapshots-request/>"))
                .contains(
                        "<snapshot name=\"a\" time=\"0.0\"/><snapshot name=\"b\" time=\"0.05\"/>");
        assertThat(admin.ask("3", "<restore-snapshot-command name=\"c\"/>"))
                .contains("code=\"UNKNOWN_ENTITY\"")
                .contains("there is no snapshot 'c'; there are a, b");
    }

    @Test
    void tooManySnapshotsAreRefused() throws IOException {
        for (int i = 0; i < 32; i++) {
            done("<take-snapshot-command name=\"s%d\"/>".formatted(i));
        }
        done("<take-snapshot-command name=\"s7\"/>");
        assertThat(admin.ask("1", "<take-snapshot-command name=\"one more\"/>"))
                .contains("code=\"REFUSED\"")
                .contains("32 snapshots are kept");
    }

    @Test
    void aResetBeginsTheScenarioAgain() throws IOException {
        done(PUSH);
        step(5);
        done("<reset-command/>");
        assertThat(x()).isZero();
        assertThat(time()).isZero();
        done(OTHER_WORLD);
        step(2);
        done("<reset-command/>");
        assertThat(time()).isEqualTo(5);
        assertThat(x()).isEqualTo(8);
    }

    @Test
    void anotherScenarioTakesThePlaceOfTheFirst() throws IOException {
        RawClient listener = listener("EntityRemoved");
        done(OTHER_WORLD);
        assertThat(listener.next("snapshot-restored-notification"))
                .contains("timestamp=\"5.0\"")
                .contains("name=\"*SCENARIO*\"");
        assertThat(admin.ask("1", "<get-world-object-list-command/>"))
                .contains("<world-object id=\"1\" type=\"WorldObject\" name=\"Whale\"/>")
                .doesNotContain("Bob");
        step(1);
        assertThat(time()).isEqualTo(5.05);
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "<world-object name='A' mass='1'><sphere radius='1'/></world-object>"
                        + "<world-object name='B' mass='1'><sphere radius='1'/></world-object>"
                        + " | INVALID_VALUE | overlap",
                "<feedback-processor override='Guess'/> | UNKNOWN_ENTITY | 'Guess'",
                "<world-object name='A'><sphere radius='1'/></world-object> | INVALID_VALUE | mass",
                "<time-step delta='-1'/> | INVALID_VALUE | time step",
                "<gridded-current id='9' name='Tide' file='tide.csv'/> | INVALID_VALUE | tide.csv",
            })
    void aScenarioThatCannotBeHadChangesNothing(String content, String code, String why)
            throws IOException {
        done(PUSH);
        step(2);
        long before = simulator.ask(world -> world.stateHash());
        assertThat(
                        admin.ask(
                                "1",
                                "<load-scenario-command><scenario>"
                                        + content
                                        + "</scenario></load-scenario-command>"))
                .contains("error-response")
                .contains(code)
                .contains(why);
        assertThat(simulator.<Long>ask(world -> world.stateHash())).isEqualTo(before);
    }

    @Test
    void clientsAreListedWithWhatTheyControl() throws IOException {
        RawClient robot = client();
        robot.ask("1", "<hello-command name=\"REMUS\"/>");
        robot.ask("2", "<take-control-command world-object-id=\"3\"/>");
        robot.ask("3", PUSH);
        assertThat(admin.ask("1", "<list-clients-request/>"))
                .contains("<client session-id=\"1\" name=\"client 1\" peer=\"127.0.0.1:")
                .contains("<client session-id=\"2\" name=\"REMUS\" peer=\"127.0.0.1:")
                .contains(
                        "role=\"admin\" awaited=\"0\"><world-object id=\"1\"/><world-object"
                                + " id=\"3\"/></client>");
    }

    @ParameterizedTest
    @CsvSource({"REMUS", "2"})
    void aClientIsDisconnectedByItsNameOrSession(String client) throws IOException {
        RawClient robot = client();
        robot.ask("1", "<hello-command name=\"REMUS\"/>");
        robot.ask("2", PUSH);
        done("<disconnect-client-command client=\"%s\" reason=\"out\"/>".formatted(client));
        assertThat(robot.rest().strip())
                .endsWith("<auvsml><disconnected-notification reason=\"out\"/></auvsml>");
        done(PUSH); // it is free again
        assertThat(admin.ask("2", "<list-clients-request/>")).doesNotContain("REMUS");
    }

    @Test
    void whoIsNotThereCannotBeDisconnected() throws IOException {
        assertThat(admin.ask("1", "<disconnect-client-command client=\"Nemo\"/>"))
                .contains("code=\"UNKNOWN_ENTITY\"")
                .contains("there is no client 'Nemo'; there is [client 1]");
    }

    @Test
    void stepsAreMadeInAnotherWayFromTheNextOneOn() throws IOException {
        RawClient listener = listener("*ALL*");
        done(PUSH);
        step(1);
        assertThat(listener.next("timestep-advanced")).contains("state-type=\"ACTUAL\"");
        done(
                "<set-timestepper-command><simple-fixed-time-feedback-timestepper wait=\"0.001\"/>"
                        + "</set-timestepper-command>");
        step(1);
        assertThat(listener.next("timestep-advanced")).contains("state-type=\"PROJECTED\"");
        assertThat(admin.ask("1", "<set-timestepper-command/>")).contains("code=\"MISSING_VALUE\"");
    }

    @Test
    void oneProcessorMayDoAllCorrections() throws IOException {
        done(
                "<set-timestepper-command><asynchronous-feedback-timestepper/>"
                        + "</set-timestepper-command>");
        done("<set-feedback-processor-command override=\"VectorAdjustmentFeedbackHandler\"/>");
        assertThat(admin.ask("1", "<set-feedback-processor-command override=\"Guess\"/>"))
                .contains("error-response")
                .contains("'Guess'");
        RawClient robot = listener("FeedbackApplied");
        assertThat(correction(robot)).contains("handler-name=\"VectorAdjustmentFeedbackHandler\"");
        done("<set-feedback-processor-command/>");
        assertThat(correction(robot))
                .contains("handler-name=\"DirectPositionChangeFeedbackHandler\"");
    }

    private String correction(RawClient robot) throws IOException {
        robot.ask(
                "feedback",
                "<different-position-feedback-message world-object-id=\"1\" timestamp=\"%s\""
                                .formatted(time())
                        + " handler-name=\"DirectPositionChangeFeedbackHandler\">"
                        + "<virtual-position x=\"0\" y=\"0\" z=\"0\"/>"
                        + "<actual-position x=\"0.1\" y=\"0\" z=\"0\"/>"
                        + "<old-position x=\"0\" y=\"0\" z=\"0\"/>"
                        + "</different-position-feedback-message>");
        step(1);
        return robot.next("feedback-applied-notification");
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "<hello-command name='a&#10;b'/> | a client's name | 000A",
                "<take-snapshot-command name='a&#13;b'/> | a snapshot's name | 000D",
                "<restore-snapshot-command name='a&#9;b'/> | a snapshot's name | 0009",
                "<disconnect-client-command client='a&#x85;b'/> | a client's name | 0085",
                "<disconnect-client-command client='a' reason='b&#x2028;'/> | the reason | 2028",
            })
    void whatComesIntoLogsIsOneLine(String message, String what, String character)
            throws IOException {
        assertThat(admin.ask("1", message))
                .contains("code=\"INVALID_VALUE\"")
                .contains(
                        "%s must be one line without control characters, but has U+%s in it"
                                .formatted(what, character));
    }

    @Test
    void aSnapshotNeedsAName() throws IOException {
        assertThat(admin.ask("1", "<take-snapshot-command name=\" \"/>"))
                .contains("code=\"INVALID_VALUE\"")
                .contains("needs a name");
    }
}
