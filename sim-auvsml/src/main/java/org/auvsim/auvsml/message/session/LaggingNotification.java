package org.auvsim.auvsml.message.session;

import org.auvsim.auvsml.message.Message;

/**
 * Somebody is too slow, and something was left out for it.
 *
 * @param side who is too slow
 * @param skipped how much was left out since the last such message: movements that a newer one
 *     replaced, if the client is too slow; steps, if the simulator is, so that the world's time
 *     falls behind its rate
 */
public record LaggingNotification(LaggingSide side, long skipped) implements Message {}
