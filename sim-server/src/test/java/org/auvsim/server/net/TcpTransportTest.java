package org.auvsim.server.net;

import static org.assertj.core.api.Assertions.assertThat;

import org.auvsim.auvsml.framing.AuvsmlReader;
import org.auvsim.auvsml.framing.Incoming;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

import java.io.IOException;
import java.io.InputStream;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.time.Duration;
import java.util.Optional;
import java.util.concurrent.atomic.AtomicInteger;

@Timeout(20)
class TcpTransportTest {
    private static final TcpLimits LIMITS =
            new TcpLimits(4, Duration.ofMillis(300), Duration.ofMillis(300));

    /** Cannot take in the first client. */
    private static final class Faulty extends ServerSocket {
        final AtomicInteger calls = new AtomicInteger();

        Faulty() throws IOException {}

        @Override
        public Socket accept() throws IOException {
            if (calls.incrementAndGet() == 1) {
                throw new IllegalStateException("a fault");
            }
            return super.accept();
        }
    }

    /** Takes no client, and says the same to each. */
    private static final class NobodyHome implements Reception {
        @Override
        public AuvsmlReader reader(InputStream in) {
            throw new AssertionError("nobody was let in");
        }

        @Override
        public Optional<ClientSession> admit(String peer) {
            return Optional.empty();
        }

        @Override
        public void received(ClientSession session, Incoming incoming) {}

        @Override
        public void left(ClientSession session) {}

        @Override
        public byte[] farewell(String reason) {
            return new byte[0];
        }
    }

    @Test
    void clientsAreTakenInAfterAFaultOfWhateverKind() throws IOException {
        Faulty server = new Faulty();
        InetAddress here = InetAddress.getLoopbackAddress();
        TcpTransport tcp = new TcpTransport(new InetSocketAddress(here, 0), LIMITS, server);
        tcp.open(new NobodyHome());
        try (Socket client = new Socket(here, tcp.port())) {
            client.setSoTimeout(10_000);
            assertThat(client.getInputStream().read()).isEqualTo(-1); // taken in and let go
            assertThat(server.calls).hasValueGreaterThan(1);
        } finally {
            tcp.close();
        }
    }
}
