package org.auvsim.core.effect;

import org.auvsim.core.description.Default;
import org.auvsim.core.description.Unit;
import org.auvsim.core.entity.BlockEffect;
import org.auvsim.core.entity.Domain;
import org.auvsim.core.entity.Effect;
import org.auvsim.core.entity.Surroundings;
import org.auvsim.core.math.Vec3;

import java.util.List;
import java.util.OptionalDouble;

/**
 * What the displaced water would weigh, upward at the centre of buoyancy (Archimedes; Fossen 2021,
 * section 4.1), and the force that accelerated it: where water moves unevenly or in time, its mass
 * times Du/Dt (Auton, Hunt &amp; Prud'homme 1988; the Froude-Krylov force of waves).
 *
 * <p>Both fade out linearly as the body leaves the water: with the centre of buoyancy half a height
 * below the surface, waves included, it is wholly wet, half a height above it dry. That is exact
 * for an upright box.
 *
 * @param volume of the water that the body displaces when it is under water (m^3), 0 or more
 * @param density of the water (kg/m^3), above 0
 * @param acceleration of gravity (m/s^2), 0 or more
 * @param centre of buoyancy (m, body)
 * @param surface height of still water (m, world)
 * @param height over which it leaves the water (m), above 0; empty: the diameter of a ball of the
 *     volume
 */
public record Buoyancy(
        @Unit("m^3") double volume,
        @Unit("kg/m^3") @Default("1025.0") double density,
        @Unit("m/s^2") @Default("9.80665") double acceleration,
        @Unit("m") @Default("0 0 0") Vec3 centre,
        @Unit("m") @Default("0.0") double surface,
        @Unit("m") OptionalDouble height)
        implements Effect {
    /**
     * Checked buoyancy.
     *
     * @throws IllegalArgumentException naming the number that is out of its range
     */
    public Buoyancy {
        Domain.atLeast0("buoyancy", "volume", volume, "m^3");
        Domain.above0("buoyancy", "density", density, "kg/m^3");
        Domain.atLeast0("buoyancy", "acceleration", acceleration, "m/s^2");
        Domain.finite("buoyancy", "centre", centre, "m");
        Domain.finite("buoyancy", "surface", surface, "m");
        height.ifPresent(h -> Domain.above0("buoyancy", "height", h, "m"));
    }

    /** The mass of the water that it displaces under water (kg). */
    public double displacedMass() {
        return density * volume;
    }

    /** The height over which it leaves the water (m). */
    double fade() {
        return height.orElse(StrictMath.cbrt(6 * volume / Math.PI));
    }

    @Override
    public BlockEffect layOut(List<List<Effect>> bySlot, Surroundings around) {
        return Layers.of(bySlot, BuoyancyBlock::new);
    }
}
