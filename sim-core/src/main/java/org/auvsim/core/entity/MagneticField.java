package org.auvsim.core.entity;

import org.auvsim.core.math.Mat3;
import org.auvsim.core.math.Vec3;

/** A field of magnetic flux density (T, world frame); those of a world add up. */
public interface MagneticField extends Field<Vec3> {
    /**
     * How the flux density changes from place to place (T/m): row i, column j is the derivative of
     * component i along axis j. This one takes central differences of the values, a millimetre to
     * either side.
     */
    default Mat3 gradientAt(Vec3 position, double time) {
        double step = 1e-3;
        Vec3 x = along(new Vec3(step, 0, 0), position, time);
        Vec3 y = along(new Vec3(0, step, 0), position, time);
        Vec3 z = along(new Vec3(0, 0, step), position, time);
        return new Mat3(x.x(), y.x(), z.x(), x.y(), y.y(), z.y(), x.z(), y.z(), z.z());
    }

    private Vec3 along(Vec3 way, Vec3 position, double time) {
        Vec3 after = valueAt(position.plus(way), time);
        return after.minus(valueAt(position.minus(way), time)).times(0.5 / way.norm());
    }
}
