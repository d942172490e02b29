package org.auvsim.core.sensor;

import org.auvsim.core.description.Unit;

/**
 * What a battery gauge read.
 *
 * @param charge left in the battery
 */
public record BatteryReading(@Unit("J") double charge) implements SensorReading {}
