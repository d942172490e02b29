package org.auvsim.core.sensor;

import org.auvsim.core.description.Unit;
import org.auvsim.core.math.Vec3;

/**
 * What an inertial measurement unit read: means since its reading before, in its axes.
 *
 * @param angularRate of its body
 * @param specificForce at its place: acceleration minus that of gravity
 */
public record ImuReading(@Unit("rad/s") Vec3 angularRate, @Unit("m/s^2") Vec3 specificForce)
        implements SensorReading {}
