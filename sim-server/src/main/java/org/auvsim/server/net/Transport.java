package org.auvsim.server.net;

/** A way by which clients reach a simulator. */
public interface Transport {
    /**
     * Opens the way: clients come in from now on, on threads of the transport's own.
     *
     * @throws TransportException if it cannot be opened
     */
    void open(Reception reception);

    /** Lets no client in any more, and ends every connection once what waits for it is sent. */
    void close();
}
