package org.auvsim.cli;

import static org.assertj.core.api.Assertions.assertThat;

import org.auvsim.auvsml.client.AuvsmlClient;
import org.auvsim.auvsml.client.Received;
import org.auvsim.auvsml.message.Message;
import org.auvsim.auvsml.message.control.ResumeSimulatorCommand;
import org.auvsim.auvsml.message.listening.ListenerRegistrationRequestCommand;
import org.auvsim.auvsml.message.movement.StateType;
import org.auvsim.auvsml.message.movement.TimestepAdvancedNotification;
import org.auvsim.auvsml.message.session.DisconnectedNotification;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

import java.net.InetAddress;
import java.net.ServerSocket;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

@Timeout(60)
class ServeTest {
    private static final Path TANK =
            CommandLineHarness.EXAMPLES.resolve("scenarios").resolve("tank.xml");

    @TempDir private Path folder;
    private CommandLineHarness auvsim;

    @BeforeEach
    void begin() {
        auvsim = new CommandLineHarness(folder);
    }

    @Test
    void clientsHearEachStepUntilItsEnd() throws Exception {
        List<Message> heard = new ArrayList<>();
        try (ServerProcess server =
                        new ServerProcess(TANK, "--paused", "--rate", "max", "--until", "0.5");
                AuvsmlClient client = AuvsmlClient.connect("127.0.0.1", server.port())) {
            client.send(
                    ListenerRegistrationRequestCommand.ofAll("1"), new ResumeSimulatorCommand());
            Optional<Received> received = client.next();
            while (received.isPresent()) {
                heard.addAll(received.get().messages());
                received = client.next();
            }
            assertThat(server.exitCode()).isZero();
        }
        assertThat(heard)
                .filteredOn(
                        m ->
                                m instanceof TimestepAdvancedNotification step
                                        && step.stateType() == StateType.ACTUAL)
                .hasSizeGreaterThanOrEqualTo(10);
        assertThat(heard).last().isInstanceOf(DisconnectedNotification.class);
    }

    @Test
    void aPortInUseIsExplained() throws Exception {
        try (ServerSocket taken = new ServerSocket(0, 1, InetAddress.getLoopbackAddress())) {
            int port = taken.getLocalPort();
            assertThat(auvsim.run("serve", TANK, "--port", port)).isEqualTo(2);
            assertThat(auvsim.err()).contains(Integer.toString(port)).hasLineCount(1);
            assertThat(auvsim.out()).isEmpty();
        }
    }

    @ParameterizedTest
    @CsvSource({
        "--port,  70000,           '--port must be 0 to 65535, but is 70000.'",
        "--bind,  no-host.invalid, '--bind: there is no address ''no-host.invalid'' here.'",
        "--bind,  0.0.0.0, '--bind 0.0.0.0 lets other machines in, and nobody there proves who he"
                + " is: say with --role viewer, controller or admin what they may do.'",
        "--until, 0, '--until must be after the scenario''s start at 0.0 s, but is 0.0 s.'",
    })
    void wrongOptionsAreExplained(String option, String value, String sentence) {
        assertThat(auvsim.run("serve", TANK, option, value)).isEqualTo(2);
        assertThat(auvsim.err()).isEqualTo(sentence + "\n");
    }

    @ParameterizedTest
    @CsvSource({"0", "-2", "quick", "NaN"})
    void wrongRatesAreExplained(String rate) {
        assertThat(auvsim.run("serve", TANK, "--rate", rate)).isEqualTo(2);
        assertThat(auvsim.err())
                .contains("expected realtime, max or a number above 0, but found '" + rate + "'");
    }

    @Test
    void anUnknownFeedbackProcessorIsExplained() throws Exception {
        Path file =
                auvsim.file(
                        "a.xml",
                        "<scenario><feedback-processor override='Guess'/>"
                                + "<world-object name='A' mass='1'><sphere radius='1'/>"
                                + "</world-object></scenario>");
        assertThat(auvsim.run("serve", file, "--port", 0)).isEqualTo(2);
        assertThat(auvsim.err())
                .startsWith(file + ": ")
                .contains("'Guess'")
                .contains("VectorAdjustmentFeedbackHandler")
                .hasLineCount(1);
    }
}
