package org.auvsim.auvsml.message.session;

import org.auvsim.auvsml.message.Message;

/** The simulation is recorded no longer, though it goes on; all clients are told. */
public record RecordingEndedNotification(String reason) implements Message {}
