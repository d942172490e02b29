package org.auvsim.auvsml.message.lockstep;

import org.auvsim.auvsml.message.Message;

/**
 * The client has its name; in lock-step it is a member.
 *
 * @param step the number of the step that is under way or was made last, 0 before the first: the
 *     first that the member has to answer, once it has sent what is to act from the next one on
 */
public record HelloResponse(long step) implements Message {}
