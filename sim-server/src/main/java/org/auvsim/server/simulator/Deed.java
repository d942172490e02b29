package org.auvsim.server.simulator;

import org.auvsim.server.net.ClientSession;

/**
 * What a client did between two steps and what can be done again when the past is corrected.
 *
 * @param name what it is called when it cannot be done again
 * @param action throws what the action threw the first time, if it is refused
 */
record Deed(ClientSession session, String name, Runnable action) {}
