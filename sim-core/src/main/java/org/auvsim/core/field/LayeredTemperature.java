package org.auvsim.core.field;

import org.auvsim.core.description.Default;
import org.auvsim.core.description.Unit;
import org.auvsim.core.entity.Domain;
import org.auvsim.core.entity.TemperatureField;
import org.auvsim.core.math.Vec3;

/**
 * Water that is colder the deeper it is: evenly, by {@code gradient}, and by {@code drop} in a
 * thermocline, T = atSurface - gradient d - drop (1 + tanh(2 (d - depth) / thickness)) / 2 at the
 * depth d. Above the surface it is as warm as there.
 *
 * @param atSurface temperature at the surface, without the thermocline's part (degrees Celsius)
 * @param gradient by which it is colder by metre of depth (K/m); below 0: warmer
 * @param drop by which it is colder below the thermocline (K)
 * @param depth of the thermocline's middle (m), 0 or more
 * @param thickness over which three quarters of the drop come about (m), above 0
 * @param surface height of the water's surface (m, world)
 */
public record LayeredTemperature(
        long id,
        String name,
        @Unit("degC") double atSurface,
        @Unit("K/m") @Default("0.0") double gradient,
        @Unit("K") @Default("0.0") double drop,
        @Unit("m") @Default("0.0") double depth,
        @Unit("m") @Default("1.0") double thickness,
        @Unit("m") @Default("0.0") double surface)
        implements TemperatureField {
    /**
     * Checked layers.
     *
     * @throws IllegalArgumentException if a number is out of its range
     */
    public LayeredTemperature {
        String field = "temperature field '" + name + "'";
        Domain.finite(field, "temperature at the surface", atSurface, "degC");
        Domain.finite(field, "gradient", gradient, "K/m");
        Domain.finite(field, "drop", drop, "K");
        Domain.atLeast0(field, "depth", depth, "m");
        Domain.above0(field, "thickness", thickness, "m");
        Domain.finite(field, "surface", surface, "m");
    }

    @Override
    public Double valueAt(Vec3 position, double time) {
        double d = Math.max(0, surface - position.z());
        double share = (1 + StrictMath.tanh(2 * (d - depth) / thickness)) / 2;
        return atSurface - gradient * d - drop * share;
    }
}
