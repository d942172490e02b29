package org.auvsim.auvsml.message.session;

import org.auvsim.auvsml.message.Message;

/**
 * The first message of a session.
 *
 * @param protocolVersion of AUVSML
 * @param server the server's name and version
 * @param role what the client may do
 */
public record WelcomeMessage(String protocolVersion, String server, long sessionId, String role)
        implements Message {
    /** The version of AUVSML that is spoken here. */
    public static final String PROTOCOL = "1";
}
