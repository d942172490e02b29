package org.auvsim.core.sensor;

import org.auvsim.core.math.Quat;
import org.auvsim.core.math.Vec3;

/** Refuses parameters of sensors that have no meaning. */
final class Check {
    private Check() {}

    static void place(String element, String name, Vec3 position) {
        if (!position.isFinite()) {
            throw refusal(element, name, "position", "finite numbers (m)", position);
        }
    }

    /** The orientation, of length 1. */
    static Quat axes(String element, String name, Quat orientation) {
        if (!orientation.isFinite() || !(orientation.norm() > 0)) {
            throw refusal(element, name, "orientation", "finite and not zero", orientation);
        }
        return Math.abs(orientation.norm() - 1) > 1e-15 ? orientation.normalized() : orientation;
    }

    static void finite(String element, String name, String what, double value, String unit) {
        if (!Double.isFinite(value)) {
            throw refusal(element, name, what, "a finite number (" + unit + ")", value);
        }
    }

    static void above0(String element, String name, String what, double value, String unit) {
        if (!(value > 0) || Double.isInfinite(value)) {
            throw refusal(element, name, what, "above 0 " + unit + " and finite", value);
        }
    }

    static void atLeast0(String element, String name, String what, double value, String unit) {
        if (!(value >= 0) || Double.isInfinite(value)) {
            throw refusal(element, name, what, "0 " + unit + " or more and finite", value);
        }
    }

    static void within(
            String element,
            String name,
            String what,
            double value,
            double least,
            double most,
            String unit) {
        if (!(value >= least && value <= most)) {
            throw refusal(element, name, what, "%s to %s %s".formatted(least, most, unit), value);
        }
    }

    private static IllegalArgumentException refusal(
            String element, String name, String what, String expected, Object value) {
        return new IllegalArgumentException(
                "the %s of %s '%s' must be %s, but is %s"
                        .formatted(what, element, name, expected, value));
    }
}
