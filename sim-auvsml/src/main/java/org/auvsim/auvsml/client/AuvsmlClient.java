package org.auvsim.auvsml.client;

import static java.nio.charset.StandardCharsets.UTF_8;

import org.auvsim.auvsml.framing.AuvsmlWriter;
import org.auvsim.auvsml.framing.Frame;
import org.auvsim.auvsml.framing.FrameReader;
import org.auvsim.auvsml.framing.Incoming;
import org.auvsim.auvsml.framing.RootDecoder;
import org.auvsim.auvsml.mapping.ContextClasses;
import org.auvsim.auvsml.mapping.MessageCatalogue;
import org.auvsim.auvsml.message.Message;
import org.auvsim.auvsml.message.session.WelcomeMessage;
import org.auvsim.auvsml.xml.Limits;

import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.io.UncheckedIOException;
import java.net.ConnectException;
import java.net.InetSocketAddress;
import java.net.Socket;
import java.net.SocketTimeoutException;
import java.util.List;
import java.util.Optional;

/**
 * A blocking connection to a simulator: {@link #send} messages, take what comes with {@link #next}.
 *
 * <p>One thread may send while another one reads; {@link #close} may come from any thread and ends
 * a {@code next()} that waits. What the simulator says and this side does not know is left out.
 */
public final class AuvsmlClient implements AutoCloseable {
    private static final int TIMEOUT = 5_000;
    private static final int PACKET = 8192;

    private final Socket socket;
    private final String address;
    private final AuvsmlWriter writer;
    private final RootDecoder decoder;
    private final FrameReader frames = new FrameReader(Limits.ANSWER);
    private final byte[] packet = new byte[PACKET];
    private final InputStream in;
    private final OutputStream out;
    private final WelcomeMessage welcome;
    private volatile boolean closed;

    private AuvsmlClient(Socket socket, String address, MessageCatalogue catalogue)
            throws IOException {
        this.socket = socket;
        this.address = address;
        this.writer = new AuvsmlWriter(catalogue);
        this.decoder = RootDecoder.lenient(catalogue, Limits.ANSWER);
        this.in = socket.getInputStream();
        this.out = socket.getOutputStream();
        this.welcome = awaitWelcome();
    }

    /**
     * A connection with AUVSML's own messages.
     *
     * @throws ConnectionException if no simulator answers there
     */
    public static AuvsmlClient connect(String host, int port) throws ConnectionException {
        return connect(host, port, MessageCatalogue.load(ContextClasses.loader()));
    }

    /**
     * A connection with the messages of a catalogue, a user's own among them.
     *
     * @throws ConnectionException if no simulator answers there
     */
    public static AuvsmlClient connect(String host, int port, MessageCatalogue catalogue)
            throws ConnectionException {
        String address = host + ":" + port;
        InetSocketAddress target = new InetSocketAddress(host, port);
        if (target.isUnresolved()) {
            throw new ConnectionException("There is no host '%s': check its name.".formatted(host));
        }
        Socket socket = new Socket();
        try {
            socket.setTcpNoDelay(true);
            socket.connect(target, TIMEOUT);
            socket.setSoTimeout(TIMEOUT);
            AuvsmlClient client = new AuvsmlClient(socket, address, catalogue);
            socket.setSoTimeout(0);
            return client;
        } catch (IOException e) {
            closeAfter(e, socket);
            throw explained(e, address);
        }
    }

    private static void closeAfter(IOException failure, Socket socket) {
        try {
            socket.close();
        } catch (IOException e) {
            failure.addSuppressed(e);
        }
    }

    private static ConnectionException explained(IOException e, String address) {
        return switch (e) {
            case ConnectionException known -> known;
            case ConnectException _ ->
                    new ConnectionException(
                            "Nobody listens at %s: start a simulator there, as with 'auvsim serve'."
                                    .formatted(address),
                            e);
            case SocketTimeoutException _ ->
                    new ConnectionException(
                            "%s did not greet within %d s: is it an AUVSML server?"
                                    .formatted(address, TIMEOUT / 1000),
                            e);
            default ->
                    new ConnectionException(
                            "Cannot connect to %s: %s.".formatted(address, e.getMessage()), e);
        };
    }

    private WelcomeMessage awaitWelcome() throws IOException {
        Received first = next().orElseThrow(() -> notAuvsml("it ended the connection"));
        if (first.messages().isEmpty()
                || !(first.messages().getFirst() instanceof WelcomeMessage greeting)) {
            throw notAuvsml("its first message is no welcome-message");
        }
        if (!greeting.protocolVersion().equals(WelcomeMessage.PROTOCOL)) {
            throw new ConnectionException(
                    "%s speaks version %s of AUVSML, this program version %s: take the same release of both."
                            .formatted(
                                    address, greeting.protocolVersion(), WelcomeMessage.PROTOCOL));
        }
        return greeting;
    }

    private ConnectionException notAuvsml(String why) {
        return new ConnectionException("%s is not an AUVSML server: %s.".formatted(address, why));
    }

    /** How the simulator greeted. */
    public WelcomeMessage welcome() {
        return welcome;
    }

    /** Where the simulator listens, as {@code host:port}. */
    public String address() {
        return address;
    }

    /** Whether this side has ended the connection. */
    public boolean isClosed() {
        return closed;
    }

    /**
     * Sends messages, together in one root element.
     *
     * @throws ConnectionException if the simulator has gone
     * @throws TooLongException if together they are longer than a simulator takes
     */
    public void send(Message... messages) throws ConnectionException {
        send(Optional.empty(), List.of(messages));
    }

    /**
     * Sends messages whose response or error comes back with {@code requestId}.
     *
     * @throws ConnectionException if the simulator has gone
     * @throws TooLongException if together they are longer than a simulator takes
     */
    public void request(String requestId, Message... messages) throws ConnectionException {
        send(Optional.of(requestId), List.of(messages));
    }

    private void send(Optional<String> requestId, List<Message> messages)
            throws ConnectionException {
        byte[] bytes = writer.write(requestId, messages);
        if (bytes.length > Limits.MESSAGE.bytes()) {
            throw new TooLongException(bytes.length, Limits.MESSAGE.bytes());
        }
        synchronized (out) {
            try {
                out.write(bytes);
                out.flush();
            } catch (IOException e) {
                throw gone(e);
            }
        }
    }

    /**
     * Waits for what comes next; empty when the simulator, or {@link #close}, has ended the
     * connection.
     *
     * @throws ConnectionException if the connection breaks, or what comes is not AUVSML
     */
    public Optional<Received> next() throws ConnectionException {
        Optional<Frame.Root> root = nextRoot();
        return root.isEmpty() ? Optional.empty() : Optional.of(decode(root.get()));
    }

    /**
     * Like {@link #next}, but the root element's text as it came.
     *
     * @throws ConnectionException if the connection breaks, or what comes is not AUVSML
     */
    public Optional<String> nextText() throws ConnectionException {
        return nextRoot().map(root -> new String(root.bytes(), UTF_8));
    }

    private Received decode(Frame.Root root) throws ConnectionException {
        return switch (decoder.decode(root)) {
            case Incoming.Request r -> new Received(r.requestId(), r.messages());
            case Incoming.Rejected rejected -> throw notAuvsml(rejected.fault().toString());
            case Incoming.End _ -> throw new AssertionError("a root element is not an end");
        };
    }

    private Optional<Frame.Root> nextRoot() throws ConnectionException {
        Optional<Frame> frame = frames.next();
        while (frame.isEmpty()) {
            int length = read();
            if (length < 0) {
                return Optional.empty();
            }
            frames.feed(packet, 0, length);
            frame = frames.next();
        }
        return switch (frame.get()) {
            case Frame.Root root -> Optional.of(root);
            case Frame.Broken broken -> throw notAuvsml(broken.fault().toString());
        };
    }

    private int read() throws ConnectionException {
        try {
            return in.read(packet);
        } catch (SocketTimeoutException e) {
            throw explained(e, address);
        } catch (IOException e) {
            if (closed) {
                return -1;
            }
            throw gone(e);
        }
    }

    private ConnectionException gone(IOException e) {
        return new ConnectionException(
                "The simulator at %s has gone: %s.".formatted(address, e.getMessage()), e);
    }

    /**
     * Ends the connection; nothing happens if it has ended.
     *
     * @throws UncheckedIOException if the system cannot end it
     */
    @Override
    public void close() {
        closed = true;
        try {
            socket.close();
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }
}
