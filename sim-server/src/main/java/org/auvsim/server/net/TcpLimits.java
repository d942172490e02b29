package org.auvsim.server.net;

import java.time.Duration;

/**
 * What a TCP transport puts up with.
 *
 * @param clients that are connected at once, at most
 * @param noProgress how long a client may let a packet wait unread before it is cut off
 * @param farewell how long the end of the transport waits for each client to read what is left
 */
public record TcpLimits(int clients, Duration noProgress, Duration farewell) {
    /** 1000 clients, 5 s without progress, 1 s for the farewell. */
    public static final TcpLimits STANDARD =
            new TcpLimits(1000, Duration.ofSeconds(5), Duration.ofSeconds(1));

    /** Limits that are all above 0. */
    public TcpLimits {
        if (clients < 1 || !noProgress.isPositive() || !farewell.isPositive()) {
            throw new IllegalArgumentException(
                    "limits of a transport must be above 0, but are %d clients, %s, %s"
                            .formatted(clients, noProgress, farewell));
        }
    }
}
