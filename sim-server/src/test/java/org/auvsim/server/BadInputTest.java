package org.auvsim.server;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import org.auvsim.server.net.TcpLimits;
import org.auvsim.server.net.TcpTransport;
import org.auvsim.server.net.TransportException;
import org.auvsim.server.simulator.Simulator;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.time.Duration;
import java.util.OptionalDouble;
import java.util.Random;

/** Whatever a client sends: it is answered or cut off, and the server and others go on. */
@Timeout(60)
class BadInputTest {
    private static final String LIST = "<auvsml><get-world-object-list-command/></auvsml>";
    private static final TcpLimits LIMITS =
            new TcpLimits(4, Duration.ofMillis(300), Duration.ofMillis(300));

    private final TcpTransport tcp =
            new TcpTransport(new InetSocketAddress(InetAddress.getLoopbackAddress(), 0), LIMITS);
    private final Simulator simulator =
            Simulator.of(Tank.world()).transport(tcp).rate(OptionalDouble.empty()).start();
    private RawClient bystander;

    BadInputTest() throws IOException {
        bystander = RawClient.welcomed(tcp.port());
    }

    @BeforeEach
    void theBystanderIsServed() throws IOException {
        assertThat(bystander.ask("before", "<get-world-object-list-command/>")).contains("Bob");
    }

    @AfterEach
    void theBystanderIsStillServed() throws IOException {
        assertThat(bystander.ask("after", "<get-world-object-list-command/>")).contains("Bob");
        try (RawClient newcomer = RawClient.welcomed(tcp.port())) {
            newcomer.send(LIST);
            assertThat(newcomer.next()).contains("myAgent");
        }
        bystander.close();
        simulator.close();
    }

    private String answerTo(String bad, String code) throws IOException {
        try (RawClient client = RawClient.welcomed(tcp.port())) {
            client.send(bad);
            String answer = client.next();
            assertThat(answer).contains("<error-response").contains("code=\"" + code + "\"");
            client.send(LIST);
            assertThat(client.next("world-object-list-response")).contains("Bob");
            return answer;
        }
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            textBlock =
                    """
                    <auvsml><pause-simulator/></auvsml>                     | UNKNOWN_MESSAGE
                    <auvsml><get-propulsor-list-request agent-id="9"/></auvsml> | UNKNOWN_ENTITY
                    <auvsml><remove-force-command world-object-id="9" force-name="f"/></auvsml> | UNKNOWN_ENTITY
                    <auvsml><take-control-command world-object-id="9"/></auvsml> | UNKNOWN_ENTITY
                    <auvsml><release-control-command world-object-id="1"/></auvsml> | NOT_IN_CONTROL
                    <auvsml><remove-entity-command entity-id="9"/></auvsml> | UNKNOWN_ENTITY
                    <auvsml><step-command/></auvsml>                        | REFUSED
                    <auvsml><command-done-response/></auvsml>               | REFUSED
                    <auvsml><set-propulsor-command world-object-id="4" name="Sail" level="1"/></auvsml> | INVALID_VALUE
                    <!DOCTYPE auvsml [<!ENTITY x SYSTEM "file:///etc/passwd">]><auvsml>&x;</auvsml> | FORBIDDEN_XML
                    <auvsml><get-world-object-list-command></auvsml>        | MALFORMED_XML
                    """)
    void isAnsweredWithItsKindOfError(String bad, String code) throws IOException {
        answerTo(bad, code);
    }

    @Test
    void oneUnknownIdInARegistrationRegistersNothing() throws IOException {
        simulator.pause();
        try (RawClient client = RawClient.welcomed(tcp.port())) {
            client.send("<auvsml>" + register("1", "9") + "</auvsml>");
            assertThat(client.next())
                    .contains("code=\"UNKNOWN_ENTITY\"")
                    .contains("no entity has the id 9; nothing of this request was done");
            simulator.advanceTimestep();
            client.send(LIST);
            assertThat(client.next()).contains("world-object-list-response"); // and no event
            client.send("<auvsml>" + register("1") + "</auvsml>");
            simulatorHasHeard(client);
            simulator.advanceTimestep();
            assertThat(client.next()).contains("movement-state-change-message");
        }
    }

    private static void simulatorHasHeard(RawClient client) throws IOException {
        assertThat(client.ask("heard", "<get-simulator-state-request/>")).contains("running");
    }

    private static String register(String... ids) {
        StringBuilder objects = new StringBuilder();
        for (String id : ids) {
            objects.append("<world-object id=\"")
                    .append(id)
                    .append("\"><listener type=\"*ALL*\"/></world-object>");
        }
        return "<listener-registration-request-command register=\"1\">"
                + objects
                + "</listener-registration-request-command>";
    }

    @Test
    void anUnknownEventTypeIsAnsweredWithTheKnownOnes() throws IOException {
        assertThat(
                        answerTo(
                                "<auvsml><listener-registration-request-command"
                                        + " register=\"1\"><world-object id=\"1\"><listener"
                                        + " type=\"Tea\"/></world-object>"
                                        + "</listener-registration-request-command></auvsml>",
                                "INVALID_VALUE"))
                .contains(
                        "no event type has the name 'Tea'; there are [*ALL*, MovementStateChange");
    }

    @Test
    void notANumberIsAnsweredWithItsPlace() throws IOException {
        String answer =
                answerTo(
                        "<auvsml>\n<apply-direct-force-command world-object-id=\"1\" name=\"f\""
                                + " orientation=\"WORLD\"><force-vector x=\"NaN\" y=\"0\" z=\"0\"/>"
                                + "</apply-direct-force-command></auvsml>",
                        "INVALID_VALUE");
        assertThat(RawClient.attribute(answer, "line")).isEqualTo("2");
    }

    @Test
    void twoMebibytesAreOneError() throws IOException {
        answerTo(
                "<auvsml><get-world-object-list-command name=\""
                        + "x".repeat(2 << 20)
                        + "\"/></auvsml>",
                "LIMIT_EXCEEDED");
    }

    @Test
    void tenThousandElementsDeepIsOneError() throws IOException {
        answerTo(
                "<auvsml>" + "<a>".repeat(10_000) + "</a>".repeat(10_000) + "</auvsml>",
                "LIMIT_EXCEEDED");
    }

    @ParameterizedTest(name = "seed {0}")
    @CsvSource({"1", "2", "3"})
    void binaryNoiseIsPassedOver(long seed) throws IOException {
        byte[] noise = new byte[100_000];
        new Random(seed).nextBytes(noise);
        try (RawClient client = RawClient.welcomed(tcp.port())) {
            client.send(noise);
            client.send(LIST);
            client.send(LIST);
            assertThat(client.next("error-response")).contains("line=");
            assertThat(client.next("world-object-list-response")).contains("Bob");
        }
    }

    @Test
    void aTruncatedMessageIsAnErrorEvenToOneWhoHasHungUp() throws IOException {
        try (RawClient client = RawClient.welcomed(tcp.port())) {
            client.send("<auvsml><get-world-object-li");
            client.endOutput();
            assertThat(client.rest())
                    .contains("the stream ended")
                    .contains("code=\"MALFORMED_XML\"");
        }
    }

    @Test
    void aBrokenConnectionFreesWhatItsClientControlled() throws IOException {
        String take = "<take-control-command world-object-id=\"1\"/>";
        try (RawClient client = RawClient.welcomed(tcp.port())) {
            client.ask("1", take);
            assertThat(bystander.ask("1", take)).contains("NOT_IN_CONTROL");
            client.send("<auvsml><apply-direct-fo");
            client.reset();
        }
        waitForClients(1);
        assertThat(bystander.ask("2", take)).contains("command-done-response");
    }

    /** Asks until only so many clients are left. */
    private void waitForClients(int count) throws IOException {
        String state = bystander.ask("n", "<get-simulator-state-request/>");
        while (!RawClient.attribute(state, "clients").equals(String.valueOf(count))) {
            state = bystander.ask("n", "<get-simulator-state-request/>");
        }
    }

    @Test
    void aClientThatNeverReadsIsCutOff() throws IOException {
        try (RawClient deaf = new RawClient(tcp.port())) {
            deaf.send(
                    "<auvsml><listener-registration-request-command register=\"1\">"
                            + "<world-object id=\"*\"><listener type=\"*ALL*\"/></world-object>"
                            + "</listener-registration-request-command></auvsml>");
            waitForClients(2);
            waitForClients(1);
        }
    }

    @Test
    void aClientThatAsksAndNeverReadsIsCutOff() throws IOException {
        try (RawClient deaf = new RawClient(tcp.port())) {
            Thread asking =
                    Thread.ofVirtual()
                            .start(
                                    () -> {
                                        try {
                                            while (true) {
                                                deaf.send(LIST.repeat(100));
                                            }
                                        } catch (IOException e) {
                                            // cut off, as it must be
                                        }
                                    });
            assertThat(joined(asking)).isTrue();
        }
        waitForClients(1);
    }

    private static boolean joined(Thread thread) {
        try {
            return thread.join(Duration.ofSeconds(40));
        } catch (InterruptedException e) {
            return false;
        }
    }

    @Test
    void oneClientTooManyIsToldSo() throws IOException {
        try (RawClient _ = RawClient.welcomed(tcp.port());
                RawClient _ = RawClient.welcomed(tcp.port());
                RawClient _ = RawClient.welcomed(tcp.port());
                RawClient tooMany = new RawClient(tcp.port())) {
            assertThat(tooMany.rest())
                    .isEqualTo(
                            "<auvsml><disconnected-notification reason=\"this server takes at most"
                                    + " 4 clients; come again later\"/></auvsml>\n");
        }
        waitForClients(1);
    }

    @Test
    void aPortInUseIsOneSentence() {
        assertThatThrownBy(
                        () ->
                                Simulator.of(Tank.world())
                                        .transport(TcpTransport.onLoopback(tcp.port()))
                                        .start())
                .isInstanceOf(TransportException.class)
                .hasMessageMatching(
                        "cannot listen at .* port "
                                + tcp.port()
                                + " \\(Address already in use\\); choose another port or address,"
                                + " or stop who uses it");
    }
}
