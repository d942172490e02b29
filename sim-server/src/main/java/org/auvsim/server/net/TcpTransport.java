package org.auvsim.server.net;

import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.util.List;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;

/**
 * Clients over TCP. A connection has two virtual threads, of which one reads and one writes; a
 * third one looks after all connections and closes those that get no further.
 */
public final class TcpTransport implements Transport {
    private static final Logger LOG = LoggerFactory.getLogger(TcpTransport.class);
    private static final int BACKLOG = 128;

    private final InetSocketAddress address;
    private final TcpLimits limits;
    private final Set<TcpConnection> connections = ConcurrentHashMap.newKeySet();
    private final ServerSocket server;
    private volatile boolean closed;

    /**
     * A transport with the {@link TcpLimits#STANDARD standard limits}.
     *
     * @param address to listen at; port 0 for any free one
     */
    public TcpTransport(InetSocketAddress address) {
        this(address, TcpLimits.STANDARD);
    }

    /**
     * A transport.
     *
     * @param address to listen at; port 0 for any free one
     */
    public TcpTransport(InetSocketAddress address, TcpLimits limits) {
        this(address, limits, unbound());
    }

    /** A transport that listens with a socket which is not bound yet. */
    TcpTransport(InetSocketAddress address, TcpLimits limits, ServerSocket server) {
        this.address = address;
        this.limits = limits;
        this.server = server;
    }

    private static ServerSocket unbound() {
        try {
            return new ServerSocket();
        } catch (IOException e) {
            throw new TransportException("this machine gives no sockets: " + e.getMessage(), e);
        }
    }

    /** A transport that only this machine reaches, at a port; 0 for any free one. */
    public static TcpTransport onLoopback(int port) {
        return new TcpTransport(new InetSocketAddress(InetAddress.getLoopbackAddress(), port));
    }

    /** The port that it listens at, once it is open. */
    public int port() {
        return server.getLocalPort();
    }

    @Override
    public void open(Reception reception) {
        try {
            server.setReuseAddress(true);
            server.bind(address, BACKLOG);
        } catch (IOException e) {
            throw new TransportException(
                    "cannot listen at %s port %d (%s); choose another port or address, or stop who uses it"
                            .formatted(address.getHostString(), address.getPort(), e.getMessage()),
                    e);
        }
        if (!server.getInetAddress().isLoopbackAddress()) {
            LOG.warn("clients of other machines may connect, and none of them proves who it is");
        }
        Thread.ofVirtual().name("accept").start(() -> accept(reception));
        Thread.ofVirtual().name("watch").start(this::watch);
    }

    /** Takes clients in until closed, whatever happens to one of them. */
    private void accept(Reception reception) {
        while (!closed) {
            try {
                Socket socket = server.accept();
                Thread.ofVirtual().start(() -> serve(socket, reception));
            } catch (IOException | RuntimeException e) {
                if (!closed) {
                    LOG.warn("a client could not come in: {}", String.valueOf(e.getMessage()));
                    rest();
                }
            }
        }
    }

    private void serve(Socket socket, Reception reception) {
        TcpConnection connection = new TcpConnection(socket);
        connections.add(connection);
        try {
            if (connections.size() > limits.clients()) {
                connection.refuse(
                        reception.farewell(
                                "this server takes at most %d clients; come again later"
                                        .formatted(limits.clients())));
            } else {
                connection.serve(reception);
            }
        } finally {
            connections.remove(connection);
        }
    }

    private void watch() {
        while (!closed) {
            rest();
            closeStalled();
        }
    }

    private void closeStalled() {
        long longest = limits.noProgress().toNanos();
        for (TcpConnection connection : connections) {
            connection.closeIfStalled(longest);
        }
    }

    private void rest() {
        try {
            Thread.sleep(limits.noProgress().dividedBy(10));
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            closed = true;
        }
    }

    @Override
    public void close() {
        closed = true;
        try {
            server.close();
        } catch (IOException e) {
            LOG.warn("the port could not be closed: {}", e.getMessage());
        }
        long deadline = System.nanoTime() + limits.farewell().toNanos();
        List.copyOf(connections).forEach(connection -> connection.end(deadline));
    }
}
