package org.auvsim.core.sensor;

import org.auvsim.core.description.Default;
import org.auvsim.core.description.Unit;
import org.auvsim.core.entity.Domain;
import org.auvsim.core.math.Mat3;
import org.auvsim.core.math.Vec3;

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
        Domain.within("a datum", "latitude", -90, 90, latitude, "degrees");
        Domain.within("a datum", "longitude", -180, 180, longitude, "degrees");
        Domain.finite("a datum", "altitude", altitude, "m");
    }

    /** The place of a point of the world (m, x east, y north, z up at the datum). */
    public GeodeticPosition toGeodetic(Vec3 world) {
        Vec3 centre = Wgs84.earthFixed(latitude, longitude, altitude);
        return Wgs84.geodetic(centre.plus(axes().times(world)));
    }

    /** The point of the world (m) at a place. */
    public Vec3 toWorld(GeodeticPosition place) {
        Vec3 there = Wgs84.earthFixed(place.latitude(), place.longitude(), place.altitude());
        Vec3 centre = Wgs84.earthFixed(latitude, longitude, altitude);
        return axes().transposed().times(there.minus(centre));
    }

    /** Turns vectors of the world into Earth-fixed ones: its columns are east, north and up. */
    private Mat3 axes() {
        double sinLat = StrictMath.sin(Math.toRadians(latitude));
        double cosLat = StrictMath.cos(Math.toRadians(latitude));
        double sinLon = StrictMath.sin(Math.toRadians(longitude));
        double cosLon = StrictMath.cos(Math.toRadians(longitude));
        return new Mat3(
                -sinLon,
                -sinLat * cosLon,
                cosLat * cosLon,
                cosLon,
                -sinLat * sinLon,
                cosLat * sinLon,
                0,
                cosLat,
                sinLat);
    }
}
