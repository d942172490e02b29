package org.auvsim.core.communication;

import org.auvsim.core.entity.Signal;

/**
 * A message as it was received.
 *
 * @param senderId the object that sent it
 * @param sender the transceiver that sent it, by its name in that object
 * @param channel of both
 * @param sentAt world time (s)
 */
public record TextMessage(long senderId, String sender, String channel, double sentAt, String text)
        implements Signal {}
