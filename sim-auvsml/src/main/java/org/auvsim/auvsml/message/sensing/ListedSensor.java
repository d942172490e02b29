package org.auvsim.auvsml.message.sensing;

import org.auvsim.core.description.Unit;

/**
 * A sensor in a list.
 *
 * @param type its class, as {@code DepthSensor}
 * @param rate readings a second
 */
public record ListedSensor(String name, String type, @Unit("Hz") double rate) {}
