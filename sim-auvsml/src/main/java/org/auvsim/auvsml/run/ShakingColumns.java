package org.auvsim.auvsml.run;

/**
 * The columns that tell how a body shakes, beside whatever else they mean. Their units do not
 * matter, but are the same in all runs that are compared.
 *
 * @param acceleration the name in the header of one axis of an accelerometer
 * @param rate that of one axis of a gyro
 */
public record ShakingColumns(String acceleration, String rate) {
    /**
     * Two columns.
     *
     * @throws IllegalArgumentException if they are the same
     */
    public ShakingColumns {
        if (acceleration.equals(rate)) {
            throw new IllegalArgumentException(
                    "shaking is told by two sensors, but '%s' is given for both".formatted(rate));
        }
    }
}
