package org.auvsim.core.effect;

import org.auvsim.core.description.Default;
import org.auvsim.core.description.Unit;
import org.auvsim.core.entity.BlockEffect;
import org.auvsim.core.entity.Domain;
import org.auvsim.core.entity.Effect;
import org.auvsim.core.entity.Surroundings;
import org.auvsim.core.math.Vec3;

import java.util.List;

/**
 * A force of constant size toward a point, none while the body's origin is within a radius of it:
 * what drives the objects of the thesis' section 8.2. Unlike a behavior, which looks once a step,
 * it follows the body through the step. It is conservative: its potential energy (J) at distance r
 * is {@code force * max(r, restRadius)}.
 *
 * @param force size (N), 0 or more
 * @param restRadius within which it does not act (m), 0 or more
 * @param target the point (m, world)
 */
public record CentralForce(
        @Unit("N") double force,
        @Unit("m") @Default("0.1") double restRadius,
        @Unit("m") Vec3 target)
        implements Effect {
    /**
     * A checked force.
     *
     * @throws IllegalArgumentException if force or radius is negative, or a number is not finite
     */
    public CentralForce {
        Domain.atLeast0("a central force", "force", force, "N");
        Domain.atLeast0("a central force", "rest radius", restRadius, "m");
        Domain.finite("a central force", "target", target, "m");
    }

    /** Potential energy (J) of a body at a place (m, world). */
    public double potentialEnergy(Vec3 position) {
        return force * Math.max(position.distance(target), restRadius);
    }

    @Override
    public boolean dependsOnPlace() {
        return true;
    }

    @Override
    public BlockEffect layOut(List<List<Effect>> bySlot, Surroundings around) {
        return Layers.of(bySlot, CentralForceBlock::new);
    }
}
