package org.auvsim.core.sensor;

import org.auvsim.core.math.Vec3;

/**
 * The ellipsoid of the World Geodetic System 1984 (NIMA TR8350.2), and coordinates fixed to Earth:
 * x through latitude and longitude 0, z through the north pole, origin at the centre (m).
 */
final class Wgs84 {
    private static final double EQUATOR = 6378137;
    private static final double FLATTENING = 1 / 298.257223563;
    private static final double POLE = EQUATOR * (1 - FLATTENING);
    private static final double E2 = FLATTENING * (2 - FLATTENING);
    private static final double SECOND_E2 = E2 / (1 - E2);

    /** Steps of Bowring's iteration; three leave less than 1e-9 m from the core to 10,000 km. */
    private static final int STEPS = 5;

    private Wgs84() {}

    static Vec3 earthFixed(double latitude, double longitude, double altitude) {
        double sine = StrictMath.sin(Math.toRadians(latitude));
        double cosine = StrictMath.cos(Math.toRadians(latitude));
        double across = EQUATOR / Math.sqrt(1 - E2 * sine * sine);
        double fromAxis = (across + altitude) * cosine;
        return new Vec3(
                fromAxis * StrictMath.cos(Math.toRadians(longitude)),
                fromAxis * StrictMath.sin(Math.toRadians(longitude)),
                (across * (1 - E2) + altitude) * sine);
    }

    /** The place of Earth-fixed coordinates (Bowring 1976). */
    static GeodeticPosition geodetic(Vec3 p) {
        double fromAxis = Math.sqrt(p.x() * p.x() + p.y() * p.y());
        double up = p.z() * EQUATOR;
        double out = fromAxis * POLE;
        for (int i = 0; i < STEPS; i++) {
            double length = Math.sqrt(up * up + out * out);
            double sine = up / length;
            double cosine = out / length;
            double rise = p.z() + SECOND_E2 * POLE * sine * sine * sine;
            double run = fromAxis - E2 * EQUATOR * cosine * cosine * cosine;
            // the tangent of the reduced latitude is that of the geodetic one, flattened
            up = rise * (1 - FLATTENING);
            out = run;
        }
        double latitude = StrictMath.atan2(up / (1 - FLATTENING), out);
        double sine = StrictMath.sin(latitude);
        double altitude =
                fromAxis * StrictMath.cos(latitude)
                        + p.z() * sine
                        - EQUATOR * Math.sqrt(1 - E2 * sine * sine);
        return new GeodeticPosition(
                Math.toDegrees(latitude), Math.toDegrees(StrictMath.atan2(p.y(), p.x())), altitude);
    }
}
