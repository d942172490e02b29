package org.auvsim.core.effect;

import org.auvsim.core.description.Default;
import org.auvsim.core.entity.Domain;
import org.auvsim.core.entity.MotionAxis;

/**
 * Elements beside the diagonal of the two damping matrices: the force or torque along {@code row}
 * that a velocity v along {@code column} brings about, -(linear + quadratic |v|) v.
 *
 * @param linear N s/m, N s or N m s, according to the two axes
 * @param quadratic N s^2/m^2, N s^2/m, N s^2 or N m s^2
 */
public record DampingTerm(
        MotionAxis row,
        MotionAxis column,
        @Default("0.0") double linear,
        @Default("0.0") double quadratic) {
    /**
     * A checked pair of elements.
     *
     * @throws IllegalArgumentException if they are on the diagonal or not finite
     */
    public DampingTerm {
        if (row == column) {
            throw new IllegalArgumentException(
                    ("the damping of %s by itself belongs to linear, quadratic or their angular"
                                    + " forms, not to a term")
                            .formatted(row));
        }
        String of = "damping of %s by %s".formatted(row, column);
        Domain.finite(of, "linear coefficient", linear, "");
        Domain.finite(of, "quadratic coefficient", quadratic, "");
    }
}
