package org.auvsim.core.entity;

import org.auvsim.core.description.Default;
import org.auvsim.core.description.Unit;
import org.auvsim.core.math.Mat3;

/**
 * The six numbers of an inertia tensor (kg m^2, body axes, about the centre of mass); {@code xy} is
 * the tensor's element, the negative of the product of inertia.
 */
public record Inertia(
        @Unit("kg m^2") double xx,
        @Unit("kg m^2") double yy,
        @Unit("kg m^2") double zz,
        @Unit("kg m^2") @Default("0.0") double xy,
        @Unit("kg m^2") @Default("0.0") double xz,
        @Unit("kg m^2") @Default("0.0") double yz) {
    /** That of a symmetric tensor. */
    public static Inertia of(Mat3 tensor) {
        return new Inertia(
                tensor.xx(), tensor.yy(), tensor.zz(), tensor.xy(), tensor.xz(), tensor.yz());
    }

    /** The tensor. */
    public Mat3 toMatrix() {
        return new Mat3(xx, xy, xz, xy, yy, yz, xz, yz, zz);
    }
}
