package org.auvsim.auvsml.message.session;

import org.auvsim.auvsml.message.Message;

/**
 * The client reads too slowly: movements were left out, each for a newer one.
 *
 * @param skipped how many since the last such message
 */
public record LaggingNotification(long skipped) implements Message {}
