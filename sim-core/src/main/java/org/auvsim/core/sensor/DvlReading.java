package org.auvsim.core.sensor;

import org.auvsim.core.description.Unit;
import org.auvsim.core.math.Vec3;

import java.util.OptionalDouble;

/**
 * What a Doppler velocity log read.
 *
 * @param velocity of its place, in its axes
 * @param reference against which the velocity is
 * @param altitude over the bottom along its z axis, the mean of its beams; only against the bottom
 */
public record DvlReading(
        @Unit("m/s") Vec3 velocity, DvlReference reference, @Unit("m") OptionalDouble altitude)
        implements SensorReading {}
