package org.auvsim.core.sensor;

import org.auvsim.core.description.Unit;

/**
 * What a thermometer read.
 *
 * @param temperature of the water or air at its place
 */
public record ThermometerReading(@Unit("degC") double temperature) implements SensorReading {}
