package org.auvsim.viz.source;

import static org.assertj.core.api.Assertions.assertThat;

import static java.nio.charset.StandardCharsets.UTF_8;

import org.auvsim.auvsml.client.AuvsmlClient;
import org.auvsim.auvsml.mapping.MessageCatalogue;
import org.auvsim.auvsml.message.Message;
import org.auvsim.auvsml.message.control.SetPropulsorCommand;
import org.auvsim.auvsml.message.control.TakeSnapshotCommand;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

import java.io.IOException;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.time.Duration;
import java.util.Scanner;
import java.util.concurrent.CompletableFuture;

/** Over real sockets. */
@Timeout(60)
class ExchangeTest {
    private static final String WELCOME =
            "<auvsml><welcome-message protocol-version=\"1\" server=\"x\" session-id=\"1\""
                    + " role=\"admin\"/></auvsml>";

    private static final Message LARGE = new TakeSnapshotCommand("s".repeat(60_000));

    @Test
    void aSimulatorThatDoesNotReadHoldsUpNobodyAndThatIsSaid() throws Exception {
        try (ServerSocket server = new ServerSocket(0, 1, InetAddress.getLoopbackAddress())) {
            CompletableFuture<Socket> accepted = CompletableFuture.supplyAsync(() -> greet(server));
            Exchange exchange = connected(server);
            CompletableFuture<Message> last = exchange.post(LARGE);
            while (!last.isDone()) {
                last = exchange.post(LARGE);
            }
            assertThat(last)
                    .isCompletedExceptionally()
                    .failsWithin(Duration.ZERO)
                    .withThrowableThat()
                    .withCauseExactlyInstanceOf(RefusedException.class) // not lost
                    .withMessageContaining("256 orders wait, and this one is left out");
            exchange.close();
            accepted.get().close();
        }
    }

    @Test
    void whatIsLongerThanASimulatorTakesIsRefusedAndTheConnectionGoesOn() throws Exception {
        try (ServerSocket server = new ServerSocket(0, 1, InetAddress.getLoopbackAddress())) {
            CompletableFuture<Socket> accepted = CompletableFuture.supplyAsync(() -> greet(server));
            Exchange exchange = connected(server);
            assertThat(exchange.ask(new TakeSnapshotCommand("s".repeat(70_000))))
                    .failsWithin(Duration.ZERO)
                    .withThrowableThat()
                    .withCauseExactlyInstanceOf(RefusedException.class)
                    .withMessageContaining("a simulator takes at most 65536 bytes at once");
            exchange.want(new TakeSnapshotCommand("short"));
            try (Socket simulator = accepted.get();
                    Scanner words = new Scanner(simulator.getInputStream(), UTF_8)) {
                assertThat(words.useDelimiter("</auvsml>").next()).contains("name=\"short\"");
            }
            exchange.close();
        }
    }

    @Test
    void whereOrdersAreLeftOutThoseThatStopAreNot() throws Exception {
        try (ServerSocket server = new ServerSocket(0, 1, InetAddress.getLoopbackAddress())) {
            CompletableFuture<Socket> accepted = CompletableFuture.supplyAsync(() -> greet(server));
            Exchange exchange = connected(server);
            while (!exchange.post(LARGE).isDone()) {
                Thread.onSpinWait();
            }
            assertThat(exchange.post(new SetPropulsorCommand(1, "Propeller", 0.5)))
                    .isCompletedExceptionally();
            CompletableFuture<Message> stop =
                    exchange.post(new SetPropulsorCommand(1, "Propeller", 0));
            assertThat(stop).isNotDone();
            try (Socket simulator = accepted.get();
                    Scanner words = new Scanner(simulator.getInputStream(), UTF_8)) {
                words.useDelimiter(">");
                String order = words.next();
                while (!order.contains("set-propulsor-command")) {
                    order = words.next();
                }
                assertThat(order).contains("level=\"0.0\"");
            }
            exchange.close();
        }
    }

    private Exchange connected(ServerSocket server) throws Exception {
        return new Exchange(
                AuvsmlClient.connect("127.0.0.1", server.getLocalPort()),
                MessageCatalogue.load(getClass().getClassLoader()));
    }

    private static Socket greet(ServerSocket server) {
        try {
            Socket client = server.accept();
            client.getOutputStream().write(WELCOME.getBytes(UTF_8));
            return client;
        } catch (IOException e) {
            throw new AssertionError(e);
        }
    }
}
