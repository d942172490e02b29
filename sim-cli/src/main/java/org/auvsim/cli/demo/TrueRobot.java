package org.auvsim.cli.demo;

import org.auvsim.core.math.Vec3;

/**
 * The robot as it really moves: surge, sway, heave and yaw, with the drag of the water and a
 * current, both of which the scenario lacks. Integrated here, by code of its own.
 */
final class TrueRobot {
    private static final double MASS = 30;
    private static final double YAW_INERTIA = 30.0 / 12 * (1.2 * 1.2 + 0.5 * 0.5);
    private static final double MAXIMUM_THRUST = 20;
    private static final double THRUSTER_ARM = 0.25;
    private static final double[] DRAG = {8, 40, 40};
    private static final double YAW_DRAG = 0.3;
    private static final Vec3 CURRENT = new Vec3(0.06, 0.04, 0);
    private static final double STEP = 0.005;

    private static final int X = 0;
    private static final int Y = 1;
    private static final int Z = 2;
    private static final int YAW = 3;
    private static final int VX = 4;
    private static final int VY = 5;
    private static final int VZ = 6;
    private static final int YAW_RATE = 7;

    private final FlightPlan plan;
    private double[] state = new double[8];
    private long steps;

    /** At rest at the origin, heading along x, at time 0. */
    TrueRobot(FlightPlan plan) {
        this.plan = plan;
    }

    /** Where it is (m, world). */
    Vec3 position() {
        return new Vec3(state[X], state[Y], state[Z]);
    }

    /** Its heading (rad), 0 along x and growing to port. */
    double heading() {
        return state[YAW];
    }

    /** Moves on to a time (s), in steps of 5 ms by the midpoint rule. */
    void moveTo(double time) {
        while ((steps + 0.5) * STEP < time) {
            double now = steps * STEP;
            double[] middle = plus(state, STEP / 2, rates(state, now));
            state = plus(state, STEP, rates(middle, now + STEP / 2));
            steps++;
        }
    }

    private static double[] plus(double[] base, double factor, double[] rate) {
        double[] sum = base.clone();
        for (int i = 0; i < sum.length; i++) {
            sum[i] += factor * rate[i];
        }
        return sum;
    }

    private double[] rates(double[] s, double time) {
        FlightPlan.Setting levels = plan.at(time);
        double cos = StrictMath.cos(s[YAW]);
        double sin = StrictMath.sin(s[YAW]);
        double east = s[VX] - CURRENT.x();
        double north = s[VY] - CURRENT.y();
        double surge =
                MAXIMUM_THRUST * (levels.port() + levels.starboard())
                        - drag(0, cos * east + sin * north);
        double sway = -drag(1, -sin * east + cos * north);
        double heave = MAXIMUM_THRUST * levels.ventral() - drag(2, s[VZ] - CURRENT.z());
        double yaw =
                MAXIMUM_THRUST * THRUSTER_ARM * (levels.starboard() - levels.port())
                        - YAW_DRAG * s[YAW_RATE];
        return new double[] {
            s[VX],
            s[VY],
            s[VZ],
            s[YAW_RATE],
            (cos * surge - sin * sway) / MASS,
            (sin * surge + cos * sway) / MASS,
            heave / MASS,
            yaw / YAW_INERTIA
        };
    }

    private static double drag(int axis, double speed) {
        return DRAG[axis] * Math.abs(speed) * speed;
    }
}
