package org.auvsim.core.entity;

import org.auvsim.core.math.Quat;
import org.auvsim.core.math.Vec3;

/**
 * Checks of the parameters of effects, fields and components: one sentence says which, what, and
 * the range.
 */
public final class Domain {
    private Domain() {}

    /** Whose parameters they are, where it has a name: "fin 'Rudder'". */
    public static String named(String kind, String name) {
        return kind + " '" + name + "'";
    }

    /** Nothing if a number is finite and in a range of any kind. */
    public static void require(
            boolean inRange,
            String of,
            String parameter,
            double value,
            String allowed,
            String unit) {
        if (!inRange || !Double.isFinite(value)) {
            throw refusal(of, parameter, allowed, value, unit);
        }
    }

    /** An orientation, scaled to length 1; refused unless finite and not zero. */
    public static Quat unit(String of, String parameter, Quat orientation) {
        if (!orientation.isFinite() || !(orientation.norm() > 0)) {
            throw refusal(of, parameter, "finite and not zero", orientation, "");
        }
        return Math.abs(orientation.norm() - 1) > 1e-15 ? orientation.normalized() : orientation;
    }

    /** A direction, scaled to length 1; refused unless finite and not zero. */
    public static Vec3 unit(String of, String parameter, Vec3 direction) {
        double square = direction.dot(direction);
        if (!direction.isFinite() || !(square > 0) || Double.isInfinite(square)) {
            throw refusal(of, parameter, "finite and not zero", direction, "");
        }
        return Math.abs(square - 1) > 1e-15 ? direction.normalized() : direction;
    }

    /** Nothing if a number is finite and not negative. */
    public static void atLeast0(String of, String parameter, double value, String unit) {
        if (!(value >= 0) || Double.isInfinite(value)) {
            throw refusal(of, parameter, quantity("0", unit) + " or more and finite", value, unit);
        }
    }

    /** Nothing if a number is finite and positive. */
    public static void above0(String of, String parameter, double value, String unit) {
        if (!(value > 0) || Double.isInfinite(value)) {
            throw refusal(of, parameter, quantity("above 0", unit) + " and finite", value, unit);
        }
    }

    /** Nothing if a number is finite. */
    public static void finite(String of, String parameter, double value, String unit) {
        if (!Double.isFinite(value)) {
            throw refusal(of, parameter, "finite", value, unit);
        }
    }

    /** Nothing if a vector is finite. */
    public static void finite(String of, String parameter, Vec3 value, String unit) {
        if (!value.isFinite()) {
            throw refusal(of, parameter, "finite", value, unit);
        }
    }

    /** Nothing if a number is in a range, its ends included. */
    public static void within(
            String of, String parameter, double least, double most, double value, String unit) {
        if (!(value >= least && value <= most)) {
            throw refusal(of, parameter, quantity(least + " to " + most, unit), value, unit);
        }
    }

    private static String quantity(String number, String unit) {
        return (number + " " + unit).strip();
    }

    private static IllegalArgumentException refusal(
            String of, String parameter, String allowed, Object value, String unit) {
        return new IllegalArgumentException(
                "the %s of %s must be %s, but is %s %s"
                        .formatted(parameter, of, allowed, value, unit)
                        .strip());
    }
}
