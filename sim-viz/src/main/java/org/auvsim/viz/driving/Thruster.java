package org.auvsim.viz.driving;

import org.auvsim.core.actuator.Propulsor;

/** A propulsor by what it reaches at full level, and the level that a share of it takes. */
final class Thruster {
    private static final int PLACES = 100;
    private static final int HALVINGS = 40;

    /** A smaller share is none. */
    private static final double LEAST = 1e-6;

    private final Propulsor propulsor;
    private final double reach;

    Thruster(Propulsor propulsor) {
        this.propulsor = propulsor;
        reach = thrust(best(1));
    }

    Propulsor propulsor() {
        return propulsor;
    }

    /** The most thrust ahead (N). */
    double reach() {
        return reach;
    }

    /** The level (-1 to 1) for a share of the reach (-1 to 1), or as much of it as there is. */
    double level(double share) {
        if (Math.abs(share) < LEAST) {
            return 0;
        }
        double sign = Math.signum(share);
        double low = 0;
        double high = Math.abs(best(sign));
        for (int i = 0; i < HALVINGS; i++) {
            double middle = (low + high) / 2;
            if (sign * thrust(sign * middle) < Math.abs(share) * reach) {
                low = middle;
            } else {
                high = middle;
            }
        }
        return sign * (propulsor.deadZone() + (1 - propulsor.deadZone()) * high);
    }

    /** The level to one side that pushes hardest: a curve may fall again before its end. */
    private double best(double sign) {
        double best = sign;
        for (int i = 1; i < PLACES; i++) {
            double level = sign * i / PLACES;
            if (sign * thrust(level) > sign * thrust(best)) {
                best = level;
            }
        }
        return best;
    }

    /** Thrust (N) at a level after the dead zone. */
    private double thrust(double level) {
        double most = propulsor.maximumThrust();
        return propulsor
                .thrustCurve()
                .map(curve -> Math.clamp(curve.thrust(level), -most, most))
                .orElse(level * most);
    }
}
