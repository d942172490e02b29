package org.auvsim.auvsml.message.session;

import org.auvsim.auvsml.message.Message;

/**
 * Somebody is too slow: a client is not told of what newer messages replaced, or a simulator's
 * world falls behind its rate.
 *
 * @param side who is too slow
 * @param skipped how much since the last such message: movements that the client was not told of;
 *     or steps that the simulator is later now than its rate asks for, each of which it still makes
 */
public record LaggingNotification(LaggingSide side, long skipped) implements Message {}
