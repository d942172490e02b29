package org.auvsim.core.entity;

import org.auvsim.core.math.Vec3;

/** Checks of the parameters of effects and fields: one sentence says which, what, and the range. */
public final class Domain {
    private Domain() {}

    /** Nothing if a number is finite and not negative. */
    public static void atLeast0(String of, String parameter, double value, String unit) {
        if (!(value >= 0) || Double.isInfinite(value)) {
            throw refusal(of, parameter, "0 " + unit + " or more and finite", value, unit);
        }
    }

    /** Nothing if a number is finite and positive. */
    public static void above0(String of, String parameter, double value, String unit) {
        if (!(value > 0) || Double.isInfinite(value)) {
            throw refusal(of, parameter, "above 0 " + unit + " and finite", value, unit);
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
            throw refusal(of, parameter, least + " to " + most + " " + unit, value, unit);
        }
    }

    private static IllegalArgumentException refusal(
            String of, String parameter, String allowed, Object value, String unit) {
        return new IllegalArgumentException(
                "the %s of %s must be %s, but is %s %s"
                        .formatted(parameter, of, allowed, value, unit)
                        .strip());
    }
}
