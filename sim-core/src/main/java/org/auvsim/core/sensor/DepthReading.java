package org.auvsim.core.sensor;

import org.auvsim.core.description.Unit;

/**
 * What a depth sensor read.
 *
 * @param depth below the surface, positive down
 */
public record DepthReading(@Unit("m") double depth) implements SensorReading {}
