package org.auvsim.server.net;

import org.auvsim.auvsml.framing.AuvsmlReader;
import org.auvsim.auvsml.framing.Incoming;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

import java.io.IOException;
import java.io.OutputStream;
import java.net.InetSocketAddress;
import java.net.Socket;
import java.time.Duration;
import java.util.Optional;

/**
 * One client's connection: a thread that reads until the client ends, and one that writes until the
 * session ends.
 */
final class TcpConnection {
    private static final Logger LOG = LoggerFactory.getLogger(TcpConnection.class);

    private final Socket socket;
    private final String peer;
    private volatile Optional<Thread> writer = Optional.empty();

    /** Whether a packet waits for the client, or all is sent and the client is to hang up. */
    private volatile boolean waitsForClient;

    private volatile long waitsSince;

    TcpConnection(Socket socket) {
        this.socket = socket;
        InetSocketAddress address = (InetSocketAddress) socket.getRemoteSocketAddress();
        this.peer = address.getHostString() + ":" + address.getPort();
    }

    /** Reads, on the calling thread, until the client ends. */
    void serve(Reception reception) {
        try (socket) {
            socket.setTcpNoDelay(true);
            Optional<ClientSession> session = reception.admit(peer);
            if (session.isPresent()) {
                converse(reception, session.get());
            }
        } catch (IOException e) {
            LOG.debug("{} is gone: {}", peer, e.getMessage());
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }

    private void converse(Reception reception, ClientSession session)
            throws IOException, InterruptedException {
        Thread writing = Thread.ofVirtual().start(() -> write(session));
        writer = Optional.of(writing);
        try {
            read(reception, session);
        } finally {
            reception.left(session);
            writing.join();
        }
    }

    private void read(Reception reception, ClientSession session)
            throws IOException, InterruptedException {
        AuvsmlReader reader = reception.reader(socket.getInputStream());
        for (Incoming next = reader.next(); !(next instanceof Incoming.End); next = reader.next()) {
            reception.received(session, next);
        }
    }

    /** Runs on the writer's thread. */
    private void write(ClientSession session) {
        try {
            OutputStream out = socket.getOutputStream();
            for (Optional<byte[]> bytes = session.nextBytes();
                    bytes.isPresent();
                    bytes = session.nextBytes()) {
                waitForClient();
                out.write(bytes.get());
                waitsForClient = false;
            }
            hangUp();
        } catch (IOException e) {
            LOG.debug("{} cannot be reached: {}", peer, e.getMessage());
            close();
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            close();
        }
    }

    private void waitForClient() {
        waitsSince = System.nanoTime();
        waitsForClient = true;
    }

    /**
     * Ends what is sent, and leaves it to the client to close: a socket that is closed with input
     * unread takes the last messages with it.
     */
    private void hangUp() throws IOException {
        waitForClient();
        socket.shutdownOutput();
    }

    /** Sends a last message to a client that does not get a session, and waits for it to close. */
    void refuse(byte[] farewell) {
        try (socket) {
            waitForClient();
            socket.getOutputStream().write(farewell);
            hangUp();
            socket.getInputStream().skip(Long.MAX_VALUE);
        } catch (IOException e) {
            LOG.debug("{} did not hear that it was refused: {}", peer, e.getMessage());
        }
    }

    /** Cuts off a client for which something has waited longer than {@code nanos}. */
    void closeIfStalled(long nanos) {
        if (waitsForClient && System.nanoTime() - waitsSince > nanos) {
            LOG.info("{} has not read for {} ms and is cut off", peer, nanos / 1_000_000);
            waitsForClient = false;
            close();
        }
    }

    /** Ends the connection when the writer is done, but at a time of the system's clock at last. */
    void end(long deadlineNanos) {
        try {
            Duration left = Duration.ofNanos(Math.max(1, deadlineNanos - System.nanoTime()));
            if (writer.isPresent() && !writer.get().join(left)) {
                LOG.info("{} did not read its last messages", peer);
            }
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
        close();
    }

    private void close() {
        try {
            socket.close();
        } catch (IOException e) {
            LOG.debug("{} could not be closed: {}", peer, e.getMessage());
        }
    }
}
