package org.auvsim.core.sensor;

import org.auvsim.core.description.Default;
import org.auvsim.core.description.Unit;

/**
 * Where the origin of a world is on Earth (WGS 84); its x axis points east there, y north and z
 * along the ellipsoid's normal.
 *
 * @param latitude geodetic, north positive, -90 to 90
 * @param longitude east positive, -180 to 180
 * @param altitude above the ellipsoid
 */
public record Datum(
        @Unit("degree") double latitude,
        @Unit("degree") double longitude,
        @Unit("m") @Default("0.0") double altitude) {
    /**
     * A checked datum.
     *
     * @throws IllegalArgumentException if an angle is outside its range or the altitude not finite
     */
    public Datum {
        if (!(latitude >= -90 && latitude <= 90)) {
            throw new IllegalArgumentException(
                    "the latitude of a datum must be -90 to 90 degrees, but is " + latitude);
        }
        if (!(longitude >= -180 && longitude <= 180)) {
            throw new IllegalArgumentException(
                    "the longitude of a datum must be -180 to 180 degrees, but is " + longitude);
        }
        if (!Double.isFinite(altitude)) {
            throw new IllegalArgumentException(
                    "the altitude of a datum must be a finite number (m), but is " + altitude);
        }
    }
}
