package org.auvsim.core.entity;

/**
 * An element beside the diagonal of an added mass matrix: the force or torque along {@code row}
 * that an acceleration along {@code column} needs.
 *
 * @param value kg, kg m or kg m^2, according to the two axes
 */
public record AddedMassTerm(MotionAxis row, MotionAxis column, double value) {
    /**
     * A checked element.
     *
     * @throws IllegalArgumentException if it is on the diagonal or not finite
     */
    public AddedMassTerm {
        if (row == column) {
            throw new IllegalArgumentException(
                    "the added mass of " + row + " itself belongs to linear or angular, not here");
        }
        if (!Double.isFinite(value)) {
            throw new IllegalArgumentException(
                    "the added mass of %s by %s must be finite, but is %s"
                            .formatted(row, column, value));
        }
    }
}
