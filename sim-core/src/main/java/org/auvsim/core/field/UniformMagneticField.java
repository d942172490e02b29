package org.auvsim.core.field;

import org.auvsim.core.description.Unit;
import org.auvsim.core.entity.Domain;
import org.auvsim.core.entity.MagneticField;
import org.auvsim.core.math.Mat3;
import org.auvsim.core.math.Vec3;

/**
 * The same flux density everywhere, as that of the earth within a bay: 25e-6 to 65e-6 T in all,
 * north and, on the northern half of the earth, down.
 *
 * @param fluxDensity (T, world)
 */
public record UniformMagneticField(long id, String name, @Unit("T") Vec3 fluxDensity)
        implements MagneticField {
    /**
     * A checked field.
     *
     * @throws IllegalArgumentException if the flux density is not finite
     */
    public UniformMagneticField {
        Domain.finite("magnetic field '" + name + "'", "flux density", fluxDensity, "T");
    }

    @Override
    public Vec3 valueAt(Vec3 position, double time) {
        return fluxDensity;
    }

    @Override
    public Mat3 gradientAt(Vec3 position, double time) {
        return Mat3.diagonal(0, 0, 0);
    }
}
