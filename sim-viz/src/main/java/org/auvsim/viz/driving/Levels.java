package org.auvsim.viz.driving;

import org.auvsim.core.actuator.Propulsor;
import org.auvsim.core.actuator.ThrustCurve;

/** Finds the level at which a propulsor pushes with a share of its maximum thrust. */
final class Levels {
    private static final double LEAST = 1e-6;
    private static final int HALVINGS = 40;

    private Levels() {}

    /** The level (-1 to 1) for a share of the maximum thrust (-1 to 1). */
    static double of(Propulsor propulsor, double share) {
        if (Math.abs(share) < LEAST) {
            return 0;
        }
        double bare =
                propulsor
                        .thrustCurve()
                        .map(
                                curve ->
                                        against(
                                                curve,
                                                share * propulsor.maximumThrust()))
                        .orElse(share);
        double dead = propulsor.deadZone();
        return Math.copySign(dead + (1 - dead) * Math.abs(bare), share);
    }

    private static double against(
            ThrustCurve curve, double thrust) {
        double sign = Math.signum(thrust);
        double low = 0;
        double high = 1;
        for (int i = 0; i < HALVINGS; i++) {
            double middle = (low + high) / 2;
            if (sign * curve.thrust(sign * middle) < Math.abs(thrust)) {
                low = middle;
            } else {
                high = middle;
            }
        }
        return sign * high;
    }
}
