package org.auvsim.auvsml.message.session;

import org.auvsim.auvsml.message.Message;

/** The last message of a session that the server ends. */
public record DisconnectedNotification(String reason) implements Message {}
