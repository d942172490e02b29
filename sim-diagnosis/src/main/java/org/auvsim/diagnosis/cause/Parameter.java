package org.auvsim.diagnosis.cause;

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
        return new Parameter(
                name, unit, scale, Double.NEGATIVE_INFINITY, Double.POSITIVE_INFINITY);
    }

    /** One that is 0 or more. */
    public static Parameter positive(String name, String unit, double scale) {
        return new Parameter(name, unit, scale, 0, Double.POSITIVE_INFINITY);
    }

    /** The nearest number that makes sense. */
    public double clipped(double value) {
        return Math.max(lowest, Math.min(highest, value));
    }
}
