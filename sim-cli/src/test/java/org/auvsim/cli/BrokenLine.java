package org.auvsim.cli;

import static java.nio.charset.StandardCharsets.ISO_8859_1;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.util.concurrent.CompletableFuture;

/** A way for one client to a server, which breaks as soon as the server has said something. */
final class BrokenLine implements AutoCloseable {
    private final ServerSocket door;
    private final CompletableFuture<Void> served;

    /** Listens on a free port; breaks after {@code last}. */
    BrokenLine(int serverPort, String last) throws IOException {
        door = new ServerSocket(0, 1, InetAddress.getLoopbackAddress());
        served = CompletableFuture.runAsync(() -> carry(serverPort, last));
    }

    String address() {
        return "127.0.0.1:" + door.getLocalPort();
    }

    private void carry(int serverPort, String last) {
        try (Socket client = door.accept();
                Socket server = new Socket(InetAddress.getLoopbackAddress(), serverPort)) {
            Thread.ofVirtual().start(() -> carryAll(client, server));
            InputStream said = server.getInputStream();
            byte[] packet = new byte[8192];
            StringBuilder heard = new StringBuilder();
            for (int length = said.read(packet); length >= 0; length = said.read(packet)) {
                client.getOutputStream().write(packet, 0, length);
                heard.append(new String(packet, 0, length, ISO_8859_1));
                if (heard.indexOf(last) >= 0) {
                    return;
                }
            }
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    private static void carryAll(Socket from, Socket to) {
        try {
            from.getInputStream().transferTo(to.getOutputStream());
        } catch (IOException _) {
            // The line is broken.
        }
    }

    @Override
    public void close() throws IOException {
        door.close();
        served.join();
    }
}
