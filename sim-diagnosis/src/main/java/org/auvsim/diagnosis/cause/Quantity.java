package org.auvsim.diagnosis.cause;

/**
 * A number of a cause as it is told to people.
 *
 * @param name as {@code k} or {@code u.x}
 * @param unit 1 for a pure number
 */
public record Quantity(String name, String unit, double value) {}
