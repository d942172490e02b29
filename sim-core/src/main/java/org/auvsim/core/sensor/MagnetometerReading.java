package org.auvsim.core.sensor;

import org.auvsim.core.description.Unit;
import org.auvsim.core.math.Vec3;

/**
 * What a magnetometer read.
 *
 * @param field magnetic flux density, in its axes
 */
public record MagnetometerReading(@Unit("T") Vec3 field) implements SensorReading {}
