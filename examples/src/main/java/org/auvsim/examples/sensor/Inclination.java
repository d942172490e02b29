package org.auvsim.examples.sensor;

import org.auvsim.core.description.Unit;
import org.auvsim.core.sensor.SensorReading;

/**
 * What an inclinometer reads.
 *
 * @param roll starboard side down
 * @param pitch nose down
 */
public record Inclination(@Unit("rad") double roll, @Unit("rad") double pitch)
        implements SensorReading {}
