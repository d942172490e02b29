package org.auvsim.auvsml.message.radio;

import org.auvsim.auvsml.message.Message;
import org.auvsim.core.description.Unit;

/**
 * A message of a modem or a radio reached a world object.
 *
 * @param timestamp when it arrived
 * @param worldObjectId whom it reached
 * @param senderId the object that sent it
 * @param sender the modem or radio that sent it, by its name in that object
 * @param channel of both
 * @param sentAt when it was sent: its travel time before it arrived
 */
public record RadioMessage(
        @Unit("s") double timestamp,
        long worldObjectId,
        long senderId,
        String sender,
        String channel,
        @Unit("s") double sentAt,
        String text)
        implements Message {}
