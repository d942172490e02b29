package org.auvsim.core.actuator;

/**
 * Lift and drag coefficients of a thin symmetric foil at any angle of attack a. Up to the stall
 * angle the flow is attached: C_L = slope a, C_D = C_D0 + k C_L^2 (Fossen 2021, section 9.7).
 * Beyond twice the stall angle it is a flat plate: C_L = 2 sin a cos a, C_D = C_D0 + 2 sin^2 a
 * (Cory and Tedrake 2008). Between them the two are blended as Beard and McLain (2012, section 4.2)
 * do, but with a cubic step, which leaves the attached flow as it is.
 */
final class Polar {
    /** Sines up to this (that of 30 degrees) are of small angles. */
    private static final double SMALL = 0.5;

    private Polar() {}

    /** The angle (rad, -pi to pi) of a flow; that of small ones costs little. */
    static double angle(double aside, double ahead) {
        double length = Math.sqrt(ahead * ahead + aside * aside);
        return ahead > 0 && Math.abs(aside) < SMALL * length
                ? StrictMath.asin(aside / length)
                : StrictMath.atan2(aside, ahead);
    }

    /** The same angle (rad) from -pi to pi, of one that is at most a turn off. */
    static double wrapped(double angle) {
        return angle > Math.PI
                ? angle - 2 * Math.PI
                : angle < -Math.PI ? angle + 2 * Math.PI : angle;
    }

    /** C_L at an angle (rad), -pi to pi. */
    static double lift(Fin fin, double angle) {
        double stalled = stalled(fin, angle);
        double attached = fin.liftSlope() * angle;
        return stalled == 0
                ? attached
                : (1 - stalled) * attached + stalled * StrictMath.sin(2 * angle);
    }

    /** C_D at an angle (rad), -pi to pi. */
    static double drag(Fin fin, double angle) {
        double stalled = stalled(fin, angle);
        double lift = fin.liftSlope() * angle;
        double attached = fin.inducedDrag() * lift * lift;
        if (stalled == 0) {
            return fin.dragCoefficient() + attached;
        }
        double sine = StrictMath.sin(angle);
        return fin.dragCoefficient() + (1 - stalled) * attached + stalled * 2 * sine * sine;
    }

    /** The share of the flat plate, 0 to 1. */
    private static double stalled(Fin fin, double angle) {
        if (Math.abs(angle) <= fin.stallAngle()) {
            return 0;
        }
        double step = Math.min(1, Math.abs(angle) / fin.stallAngle() - 1);
        return step * step * (3 - 2 * step);
    }
}
