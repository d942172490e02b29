package org.auvsim.auvsml.message.lockstep;

import org.auvsim.auvsml.message.Message;

/**
 * The client has its name; in lock-step it is a member.
 *
 * @param step the number of the next step that will be shown: the first in which the member counts
 *     and that it has to answer
 */
public record HelloResponse(long step) implements Message {}
