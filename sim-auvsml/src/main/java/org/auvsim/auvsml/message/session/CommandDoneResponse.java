package org.auvsim.auvsml.message.session;

import org.auvsim.auvsml.message.Message;

/**
 * A command with a request-id was carried out and has no response of its own; without a request-id
 * nothing is sent.
 */
public record CommandDoneResponse() implements Message {}
