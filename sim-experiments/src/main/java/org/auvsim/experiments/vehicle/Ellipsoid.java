package org.auvsim.experiments.vehicle;

import org.auvsim.core.math.Vec3;

/**
 * Added mass of an ellipsoid in water without bounds (Lamb, <i>Hydrodynamics</i>, 6th ed., 1932,
 * articles 114 and 115).
 *
 * @param a half the length (m)
 * @param b half the breadth (m)
 * @param c half the height (m)
 */
record Ellipsoid(double a, double b, double c) {
    /** From here on the series' cubic terms are below rounding. */
    private static final double PRECISE = 1e-6;

    double volume() {
        return 4 * Math.PI / 3 * a * b * c;
    }

    /** Lamb's alpha, beta and gamma: abc times the integral of dt/((a^2 + t) sqrt(...)), ... */
    private Vec3 lamb() {
        double factor = 2.0 / 3 * a * b * c;
        return new Vec3(
                factor * carlson(b * b, c * c, a * a),
                factor * carlson(a * a, c * c, b * b),
                factor * carlson(a * a, b * b, c * c));
    }

    /** Added mass (kg) along the three axes in water of a density (kg/m^3). */
    Vec3 linear(double density) {
        Vec3 k = lamb();
        return new Vec3(k.x() / (2 - k.x()), k.y() / (2 - k.y()), k.z() / (2 - k.z()))
                .times(density * volume());
    }

    /** Added moments of inertia (kg m^2) about the three axes in water of a density (kg/m^3). */
    Vec3 angular(double density) {
        Vec3 k = lamb();
        return new Vec3(
                        turning(b * b, c * c, k.y(), k.z()),
                        turning(c * c, a * a, k.z(), k.x()),
                        turning(a * a, b * b, k.x(), k.y()))
                .times(density * volume() / 5);
    }

    private static double turning(double p, double q, double kp, double kq) {
        double difference = p - q;
        double divisor = 2 * difference + (p + q) * (kp - kq);
        return Math.abs(difference) < 1e-12 * (p + q)
                ? 0
                : difference * difference * (kq - kp) / divisor;
    }

    /** Carlson's R_D(x, y, z) by duplication (Numer. Math. 33, 1979, pp. 1 to 16). */
    private static double carlson(double x, double y, double z) {
        double sum = 0;
        double factor = 1;
        double mean = (x + y + 3 * z) / 5;
        while (Math.max(Math.abs(mean - x), Math.max(Math.abs(mean - y), Math.abs(mean - z)))
                > PRECISE * mean) {
            double lambda = Math.sqrt(x * y) + Math.sqrt(x * z) + Math.sqrt(y * z);
            sum += factor / (Math.sqrt(z) * (z + lambda));
            factor /= 4;
            x = (x + lambda) / 4;
            y = (y + lambda) / 4;
            z = (z + lambda) / 4;
            mean = (x + y + 3 * z) / 5;
        }
        double dx = (mean - x) / mean;
        double dy = (mean - y) / mean;
        double dz = (mean - z) / mean;
        double second = dx * dy - 6 * dz * dz;
        return 3 * sum + factor * (1 - 3.0 / 14 * second) / (mean * Math.sqrt(mean));
    }
}
