package org.auvsim.core.entity;

import org.auvsim.core.description.Default;
import org.auvsim.core.description.Unit;
import org.auvsim.core.math.Vec3;

/**
 * A constant force on a rigid body, known by its name (thesis, section 4.1).
 *
 * @param frame the axes of {@code vector}
 * @param vector the force (N)
 * @param point where it acts, in body coordinates (m) whatever the frame; away from the origin it
 *     also induces a torque
 */
public record NamedForce(
        String name,
        @Default("WORLD") Frame frame,
        @Unit("N") Vec3 vector,
        @Unit("m") @Default("0 0 0") Vec3 point) {
    /**
     * A force that acts at a point.
     *
     * @throws IllegalArgumentException if a number is not finite
     */
    public NamedForce {
        if (!vector.isFinite() || !point.isFinite()) {
            throw new IllegalArgumentException(
                    "force '" + name + "' must be finite, but is " + vector + " N at " + point);
        }
    }

    /** A force that acts at the body's origin and induces no torque. */
    public static NamedForce direct(String name, Frame frame, Vec3 vector) {
        return new NamedForce(name, frame, vector, Vec3.ZERO);
    }
}
