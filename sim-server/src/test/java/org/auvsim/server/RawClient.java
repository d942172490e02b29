package org.auvsim.server;

import java.io.IOException;
import java.io.InputStream;
import java.net.InetAddress;
import java.net.Socket;
import java.nio.charset.StandardCharsets;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * A client as anyone could write it: a socket and strings, nothing of ours. Whatever it waits for
 * must come within its socket's timeout.
 */
public final class RawClient implements AutoCloseable {
    private static final int TIMEOUT = 20_000;
    private static final Pattern ROOT = Pattern.compile("<auvsml[ >].*?</auvsml>", Pattern.DOTALL);

    private final Socket socket;
    private final StringBuilder received = new StringBuilder();

    /** Connects to this machine. */
    public RawClient(int port) throws IOException {
        socket = new Socket(InetAddress.getLoopbackAddress(), port);
        socket.setSoTimeout(TIMEOUT);
        socket.setTcpNoDelay(true);
    }

    /** Connects, and passes over the welcome. */
    public static RawClient welcomed(int port) throws IOException {
        RawClient client = new RawClient(port);
        client.next("welcome-message");
        return client;
    }

    /** Sends text as it is. */
    public void send(String text) throws IOException {
        send(text.getBytes(StandardCharsets.UTF_8));
    }

    /** Sends bytes as they are. */
    public void send(byte[] bytes) throws IOException {
        socket.getOutputStream().write(bytes);
        socket.getOutputStream().flush();
    }

    /** The next root element, whatever it holds. */
    public String next() throws IOException {
        Matcher root = ROOT.matcher(received);
        while (!root.find()) {
            readMore();
            root = ROOT.matcher(received);
        }
        String text = root.group();
        received.delete(0, root.end());
        return text;
    }

    /** The next root element that holds a message of this name; others are passed over. */
    public String next(String message) throws IOException {
        String root = next();
        while (!root.contains("<" + message)) {
            root = next();
        }
        return root;
    }

    /** Sends a request with an id and waits for its answer; others are passed over. */
    public String ask(String requestId, String message) throws IOException {
        send("<auvsml request-id=\"" + requestId + "\">" + message + "</auvsml>");
        String root = next();
        while (!root.contains("request-id=\"" + requestId + "\"")) {
            root = next();
        }
        return root;
    }

    /** All that comes until the server ends the connection. */
    public String rest() throws IOException {
        try {
            while (true) {
                readMore();
            }
        } catch (ServerHasHungUp e) {
            return received.toString();
        }
    }

    private void readMore() throws IOException {
        InputStream in = socket.getInputStream();
        byte[] packet = new byte[8192];
        int length = in.read(packet);
        if (length < 0) {
            throw new ServerHasHungUp(received.toString());
        }
        received.append(new String(packet, 0, length, StandardCharsets.UTF_8));
    }

    /** Says that nothing more will be sent. */
    public void endOutput() throws IOException {
        socket.shutdownOutput();
    }

    /** Breaks the connection off, as a machine that fails does. */
    public void reset() throws IOException {
        socket.setSoLinger(true, 0);
        socket.close();
    }

    /** An attribute's value in a text. */
    public static String attribute(String text, String name) {
        Matcher matcher = Pattern.compile("\\b" + name + "=\"([^\"]*)\"").matcher(text);
        if (!matcher.find()) {
            throw new AssertionError("no attribute " + name + " in " + text);
        }
        return matcher.group(1);
    }

    /** The number that an attribute of the first element of a name holds. */
    public static double number(String text, String element, String name) {
        int start = text.indexOf("<" + element);
        if (start < 0) {
            throw new AssertionError("no element " + element + " in " + text);
        }
        return Double.parseDouble(attribute(text.substring(start), name));
    }

    @Override
    public void close() throws IOException {
        socket.close();
    }

    /** The server has ended the connection. */
    static final class ServerHasHungUp extends IOException {
        private static final long serialVersionUID = 1;

        ServerHasHungUp(String unread) {
            super("the server has hung up; unread: " + unread);
        }
    }
}
