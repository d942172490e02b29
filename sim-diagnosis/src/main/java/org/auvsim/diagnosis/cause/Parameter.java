package org.auvsim.diagnosis.cause;

import java.util.List;

/**
 * A number of a cause that is searched for.
 *
 * @param unit as in reports, 1 for a pure number
 * @param scale of a change that is small, but can be told
 * @param lowest that makes sense
 * @param highest that makes sense
 */
public record Parameter(String name, String unit, double scale, double lowest, double highest) {
    /** One that may be any number. */
    public static Parameter signed(String name, String unit, double scale) {
        return new Parameter(name, unit, scale, Double.NEGATIVE_INFINITY, Double.POSITIVE_INFINITY);
    }

    /** The three of a vector, which may be any numbers: {@code u.x}, {@code u.y}, {@code u.z}. */
    public static List<Parameter> vector(String name, String unit, double scale) {
        return List.of(
                signed(name + ".x", unit, scale),
                signed(name + ".y", unit, scale),
                signed(name + ".z", unit, scale));
    }

    /** One that cannot be anything but 0, as what it would do is kept from being done. */
    static Parameter held(String name, String unit, double scale) {
        return new Parameter(name, unit, scale, 0, 0);
    }

    /** Whether it can be more than one number. */
    public boolean isFree() {
        return lowest < highest;
    }

    /** One that is 0 or more. */
    public static Parameter positive(String name, String unit, double scale) {
        return new Parameter(name, unit, scale, 0, Double.POSITIVE_INFINITY);
    }

    /** The same, but no lower. */
    Parameter atLeast(double other) {
        return new Parameter(name, unit, scale, other, highest);
    }

    /** The nearest number that makes sense. */
    public double clipped(double value) {
        return Math.max(lowest, Math.min(highest, value));
    }
}
