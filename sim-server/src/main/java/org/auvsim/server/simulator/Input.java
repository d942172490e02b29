package org.auvsim.server.simulator;

import org.auvsim.auvsml.framing.Incoming;
import org.auvsim.server.net.ClientSession;

/**
 * What decides, beside the scenario, how a simulation goes on. Inputs are taken by the simulation
 * thread, one after the other: the same inputs at the same places lead to the same states, bit for
 * bit.
 */
public sealed interface Input {
    /** A client has come. */
    record Came(ClientSession session) implements Input {}

    /** A client has sent messages. */
    record Sent(ClientSession session, Incoming.Request request) implements Input {}

    /** A client has sent what cannot be read; nothing but the answer comes of it. */
    record Unreadable(ClientSession session, Incoming.Rejected rejected) implements Input {}

    /** A client has gone. */
    record Went(ClientSession session) implements Input {}

    /** A step has waited for its members as long as it may. */
    record TimedOut() implements Input {}

    /** The program around the simulator has a question, or changes the world: no log knows how. */
    record Asked(Runnable question) implements Input {}
}
