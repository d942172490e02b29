package org.auvsim.auvsml.client;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import static java.nio.charset.StandardCharsets.UTF_8;

import org.auvsim.auvsml.message.control.PauseSimulatorCommand;
import org.auvsim.auvsml.message.control.ResumeSimulatorCommand;
import org.auvsim.auvsml.message.movement.StateType;
import org.auvsim.auvsml.message.movement.TimestepAdvancedNotification;
import org.auvsim.auvsml.message.session.CommandDoneResponse;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;

@Timeout(30)
class AuvsmlClientTest {
    private static final String WELCOME =
            "<auvsml><welcome-message protocol-version=\"1\" server=\"test\" session-id=\"7\""
                    + " role=\"admin\"/></auvsml>\n";

    private ServerSocket listening;
    private CompletableFuture<Void> serving = CompletableFuture.completedFuture(null);

    @BeforeEach
    void listen() throws IOException {
        listening = new ServerSocket(0, 1, InetAddress.getLoopbackAddress());
    }

    @AfterEach
    void stop() throws IOException {
        serving.join();
        listening.close();
    }

    /** What a server does with its one connection. */
    private interface Side {
        void talk(Socket socket) throws IOException;
    }

    private void serve(Side side) {
        serving =
                CompletableFuture.runAsync(
                        () -> {
                            try (Socket socket = listening.accept()) {
                                side.talk(socket);
                            } catch (IOException e) {
                                throw new UncheckedIOException(e);
                            }
                        });
    }

    private static void say(Socket socket, String text) throws IOException {
        socket.getOutputStream().write(text.getBytes(UTF_8));
    }

    private AuvsmlClient connect() throws ConnectionException {
        return AuvsmlClient.connect("127.0.0.1", listening.getLocalPort());
    }

    @Test
    void readsWhatComesAndEndsWithTheServer() throws Exception {
        serve(
                socket ->
                        say(
                                socket,
                                WELCOME
                                        + "<auvsml"
                                        + " request-id=\"a\"><command-done-response/></auvsml><auvsml><timestep-advanced-notification"
                                        + " timestamp=\"1.5\" state-type=\"ACTUAL\"/></auvsml>"));
        try (AuvsmlClient client = connect()) {
            assertThat(client.welcome().sessionId()).isEqualTo(7);
            assertThat(client.next())
                    .contains(new Received(Optional.of("a"), List.of(new CommandDoneResponse())));
            assertThat(client.next().orElseThrow().messages())
                    .containsExactly(new TimestepAdvancedNotification(1.5, StateType.ACTUAL));
            assertThat(client.next()).isEmpty();
            assertThat(client.next()).isEmpty();
        }
    }

    @Test
    void leavesOutWhatItDoesNotKnow() throws Exception {
        serve(
                socket ->
                        say(
                                socket,
                                WELCOME
                                        + "<auvsml><sonar-echo strength=\"3\"/>"
                                        + "<command-done-response mood=\"glad\"/></auvsml>"));
        try (AuvsmlClient client = connect()) {
            assertThat(client.next().orElseThrow().messages())
                    .containsExactly(new CommandDoneResponse());
        }
    }

    @Test
    void givesTheTextAsItCame() throws Exception {
        String text = "<auvsml>\n  <sonar-echo  name='ä'/>\n</auvsml>";
        serve(socket -> say(socket, WELCOME + text));
        try (AuvsmlClient client = connect()) {
            assertThat(client.nextText()).contains(text);
            assertThat(client.nextText()).isEmpty();
        }
    }

    @Test
    void sendsMessagesTogetherAndWithARequestId() throws Exception {
        CompletableFuture<String> heard = new CompletableFuture<>();
        serve(
                socket -> {
                    say(socket, WELCOME);
                    heard.complete(new String(socket.getInputStream().readAllBytes(), UTF_8));
                });
        try (AuvsmlClient client = connect()) {
            client.send(new PauseSimulatorCommand(), new ResumeSimulatorCommand());
            client.request("9", new PauseSimulatorCommand());
        }
        assertThat(heard.get().replaceAll("\\s+<", "<").strip())
                .isEqualTo(
                        "<auvsml><pause-simulator-command/><resume-simulator-command/></auvsml>"
                                + "<auvsml request-id=\"9\"><pause-simulator-command/></auvsml>");
    }

    @Test
    void closingEndsAReadThatWaits() throws Exception {
        CompletableFuture<Void> over = new CompletableFuture<>();
        serve(
                socket -> {
                    say(socket, WELCOME);
                    over.join();
                });
        AuvsmlClient client = connect();
        CompletableFuture<Optional<Received>> read =
                CompletableFuture.supplyAsync(
                        () -> {
                            try {
                                return client.next();
                            } catch (ConnectionException e) {
                                throw new AssertionError(e);
                            }
                        });
        client.close();
        assertThat(read.get()).isEmpty();
        over.complete(null);
    }

    @Test
    void nobodyListening() throws Exception {
        int port = listening.getLocalPort();
        listening.close();
        assertThatThrownBy(() -> AuvsmlClient.connect("127.0.0.1", port))
                .isInstanceOf(ConnectionException.class)
                .hasMessage(
                        "Nobody listens at 127.0.0.1:%d: start a simulator there, as with 'auvsim"
                                + " serve'.",
                        port);
    }

    @Test
    void noSuchHost() {
        assertThatThrownBy(() -> AuvsmlClient.connect("no-such-host.invalid", 40001))
                .isInstanceOf(ConnectionException.class)
                .hasMessage("There is no host 'no-such-host.invalid': check its name.");
    }

    @Test
    void anotherKindOfServer() {
        serve(socket -> say(socket, "SSH-2.0-OpenSSH_9.6\r\n"));
        assertThatThrownBy(this::connect)
                .isInstanceOf(ConnectionException.class)
                .hasMessage(
                        "127.0.0.1:%d is not an AUVSML server: line 1, column 1: expected <auvsml>,"
                                + " but found something else.",
                        listening.getLocalPort());
    }

    @Test
    void aServerThatEndsTheConnectionAtOnce() {
        serve(_ -> {});
        assertThatThrownBy(this::connect)
                .isInstanceOf(ConnectionException.class)
                .hasMessageEndingWith("is not an AUVSML server: it ended the connection.");
    }

    @Test
    void aServerThatBreaksOff() throws Exception {
        CompletableFuture<Void> sent = new CompletableFuture<>();
        serve(
                socket -> {
                    say(socket, WELCOME);
                    sent.join();
                    socket.setSoLinger(true, 0); // the connection is reset, not ended
                });
        try (AuvsmlClient client = connect()) {
            sent.complete(null);
            assertThatThrownBy(client::next)
                    .isInstanceOf(ConnectionException.class)
                    .hasMessageMatching(
                            "The simulator at 127\\.0\\.0\\.1:\\d+ has gone: Connection reset\\.");
        }
    }
}
