package org.auvsim.core.entity;

import org.auvsim.core.math.Mat3;

/**
 * Mass (kg) and inertia tensor (kg m^2, body axes, about the centre of mass, which is the body's
 * origin).
 */
public record MassProperties(double mass, Mat3 inertia) {
    /**
     * Checked mass properties.
     *
     * @throws IllegalArgumentException if the mass is not positive and finite, or the tensor is not
     *     symmetric and positive definite
     */
    public MassProperties {
        if (!(mass > 0) || Double.isInfinite(mass)) {
            throw new IllegalArgumentException(
                    "mass must be above 0 kg and finite, but is " + mass + " kg");
        }
        if (!inertia.isSymmetric()) {
            throw new IllegalArgumentException(
                    "an inertia tensor must be symmetric, but is " + inertia);
        }
        if (!isPositiveDefinite(inertia)) {
            throw new IllegalArgumentException(
                    "an inertia tensor must be finite and positive definite, but has xx = %s, yy = %s,"
                                    .formatted(inertia.xx(), inertia.yy())
                            + " zz = %s, xy = %s, xz = %s, yz = %s kg m^2"
                                    .formatted(
                                            inertia.zz(),
                                            inertia.xy(),
                                            inertia.xz(),
                                            inertia.yz()));
        }
    }

    /** Sylvester's criterion: all leading minors are positive. */
    private static boolean isPositiveDefinite(Mat3 m) {
        return m.xx() > 0
                && m.xx() * m.yy() - m.xy() * m.yx() > 0
                && m.determinant() > 0
                && Double.isFinite(m.determinant());
    }

    /** The inverse of the inertia tensor. */
    public Mat3 inverseInertia() {
        return inertia.inverse().orElseThrow();
    }
}
