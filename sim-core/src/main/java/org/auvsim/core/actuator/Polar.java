package org.auvsim.core.actuator;

/**
 * Lift and drag coefficients of a thin symmetric foil at any angle of attack a. Up to the stall
 * angle the flow is attached: C_L = slope a, C_D = C_D0 + k C_L^2 (Fossen 2021, section 9.7).
 * Beyond twice the stall angle it is a flat plate: C_L = 2 sin a cos a, C_D = C_D0 + 2 sin^2 a
 * (Cory and Tedrake 2008). Between them the two are blended as Beard and McLain (2012, section 4.2)
 * do, but with a cubic step, which leaves the attached flow as it is.
 */
final class Polar {
    private Polar() {}

    /** C_L at an angle (rad), -pi to pi, whose sine and cosine are given. */
    static double lift(Fin fin, double angle, double sine, double cosine) {
        double stalled = stalled(fin, angle);
        return (1 - stalled) * fin.liftSlope() * angle + stalled * 2 * sine * cosine;
    }

    /** C_D at an angle (rad) whose sine is given. */
    static double drag(Fin fin, double angle, double sine) {
        double stalled = stalled(fin, angle);
        double attached = fin.liftSlope() * angle;
        return fin.dragCoefficient()
                + (1 - stalled) * fin.inducedDrag() * attached * attached
                + stalled * 2 * sine * sine;
    }

    /** The share of the flat plate, 0 to 1. */
    private static double stalled(Fin fin, double angle) {
        double x = Math.abs(angle) / fin.stallAngle() - 1;
        double step = Math.max(0, Math.min(1, x));
        return step * step * (3 - 2 * step);
    }
}
