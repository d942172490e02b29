package org.auvsim.core.sensor;

/**
 * A place on Earth (WGS 84).
 *
 * @param latitude geodetic (degrees, north positive)
 * @param longitude (degrees, east positive, -180 to 180)
 * @param altitude above the ellipsoid (m)
 */
public record GeodeticPosition(double latitude, double longitude, double altitude) {}
