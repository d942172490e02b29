package org.auvsim.core.sensor;

import org.auvsim.core.description.Unit;

/**
 * What a satellite receiver read (WGS 84).
 *
 * @param latitude geodetic, north positive
 * @param longitude east positive
 * @param altitude above the ellipsoid
 */
public record GpsReading(
        @Unit("degree") double latitude,
        @Unit("degree") double longitude,
        @Unit("m") double altitude)
        implements SensorReading {}
