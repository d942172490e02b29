package org.auvsim.auvsml.message.command;

import java.util.OptionalDouble;

/**
 * How a simulator stands.
 *
 * @param time the world's time (s)
 * @param running whether time goes on
 * @param rate world seconds a second that are aimed at; empty: as fast as possible
 * @param step steps made
 * @param clients sessions that are open
 */
public record SimulatorState(
        double time, boolean running, OptionalDouble rate, long step, int clients) {}
