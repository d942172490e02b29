package org.auvsim.core.field;

/**
 * How fast a vortex of circulation G turns at a distance r from its axis, for a core of radius a.
 * Each gives the rate v/r (rad/s) as a function of s = r^2, as that is smooth on the axis.
 */
public enum VortexProfile {
    /** v = G / (2 pi r) (1 - exp(-r^2/a^2)), smooth everywhere (Lamb 1932, section 334a). */
    LAMB_OSEEN {
        @Override
        double rate(double s, double a) {
            return s < SMALL * a * a
                    ? series(s / (a * a)) / (a * a)
                    : -StrictMath.expm1(-s / (a * a)) / s;
        }

        @Override
        double change(double s, double a) {
            double q = s / (a * a);
            double change =
                    q < SMALL
                            ? -1.0 / 2 + q * (1.0 / 3 - q * (1.0 / 8 - q * (1.0 / 30)))
                            : (q * StrictMath.exp(-q) + StrictMath.expm1(-q)) / (q * q);
            return change / (a * a * a * a);
        }

        // (1 - exp(-q)) / q to 1e-16.
        private static double series(double q) {
            return 1 - q * (1.0 / 2 - q * (1.0 / 6 - q * (1.0 / 24 - q / 120)));
        }
    },

    /** A core that turns as if it were solid, and v = G / (2 pi r) outside of it (Rankine 1858). */
    RANKINE {
        @Override
        double rate(double s, double a) {
            return 1 / Math.max(s, a * a);
        }

        @Override
        double change(double s, double a) {
            return s > a * a ? -1 / (s * s) : 0;
        }
    },

    /** v = G r / (2 pi (r^2 + a^2)), smooth and slow to end (Kaufmann 1962; Scully 1975). */
    KAUFMANN {
        @Override
        double rate(double s, double a) {
            return 1 / (s + a * a);
        }

        @Override
        double change(double s, double a) {
            return -1 / ((s + a * a) * (s + a * a));
        }
    };

    /** Up to which share of the core's square the series are used. */
    private static final double SMALL = 1e-3;

    /** 2 pi v / (r G) (1/m^2) at r^2 = s (m^2). */
    abstract double rate(double s, double a);

    /** The derivative of {@link #rate} by s (1/m^4). */
    abstract double change(double s, double a);
}
