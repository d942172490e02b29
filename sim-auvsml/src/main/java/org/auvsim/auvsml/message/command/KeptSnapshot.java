package org.auvsim.auvsml.message.command;

import org.auvsim.core.description.Unit;

/**
 * A snapshot that a simulator keeps.
 *
 * @param time of the world in it
 */
public record KeptSnapshot(String name, @Unit("s") double time) {}
