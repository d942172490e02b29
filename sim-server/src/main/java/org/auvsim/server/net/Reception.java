package org.auvsim.server.net;

import org.auvsim.auvsml.framing.AuvsmlReader;
import org.auvsim.auvsml.framing.Incoming;

import java.io.InputStream;
import java.util.Optional;

/**
 * Where a transport brings its clients: the simulator, as a transport sees it. May be called by
 * many threads, and lets them wait while the simulator has too much to do.
 */
public interface Reception {
    /** A reader of what a client sends. */
    AuvsmlReader reader(InputStream in);

    /**
     * Begins a session.
     *
     * @param peer where the client is, as {@code 127.0.0.1:51234}
     * @return empty if no more clients are taken
     */
    Optional<ClientSession> admit(String peer) throws InterruptedException;

    /** Takes what a client has sent. */
    void received(ClientSession session, Incoming incoming) throws InterruptedException;

    /** A client sends nothing more: its session ends when what it has sent is answered. */
    void left(ClientSession session) throws InterruptedException;

    /** The last message to a client that gets no session, with the reason. */
    byte[] farewell(String reason);
}
