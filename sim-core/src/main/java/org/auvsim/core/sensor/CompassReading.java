package org.auvsim.core.sensor;

import org.auvsim.core.description.Unit;

/**
 * What a compass read.
 *
 * @param heading clockwise from north, from 0 up to a full turn: east is half of pi
 */
public record CompassReading(@Unit("rad") double heading) implements SensorReading {}
