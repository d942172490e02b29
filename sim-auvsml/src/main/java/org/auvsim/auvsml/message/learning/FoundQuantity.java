package org.auvsim.auvsml.message.learning;

import java.util.OptionalDouble;

/**
 * A number of a cause.
 *
 * @param name as {@code k} or {@code u.x}
 * @param unit 1 for a pure number
 * @param deviation the standard deviation of the value, if one can be stated
 */
public record FoundQuantity(String name, String unit, double value, OptionalDouble deviation) {}
