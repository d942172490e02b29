package org.auvsim.core.effect;

import org.auvsim.core.description.Default;
import org.auvsim.core.description.Unit;
import org.auvsim.core.entity.BlockEffect;
import org.auvsim.core.entity.Domain;
import org.auvsim.core.entity.Effect;
import org.auvsim.core.entity.Surroundings;

import java.util.List;

/**
 * Friction of a pivot that a pinned body turns in: tau = -(T / max(|w|, s) + c) w, Coulomb friction
 * T against the angular velocity w and a viscous part. Below the slip rate s the Coulomb part falls
 * to nothing in proportion to w, as a solver cannot hold a force that jumps: what should stick
 * creeps, at s times the share of T that is asked for (Armstrong-Helouvry, Dupont &amp; Canudas de
 * Wit, Automatica 30, 1994). With time steps of h and a moment of inertia I, s should be T h / I or
 * more: below that the body does not come to rest but trembles with up to half of it.
 *
 * @param coulomb T (N m), 0 or more
 * @param viscous c (N m s/rad), 0 or more
 * @param slipRate s (rad/s), above 0
 */
public record PivotFriction(
        @Unit("N m") @Default("0.0") double coulomb,
        @Unit("N m s/rad") @Default("0.0") double viscous,
        @Unit("rad/s") @Default("0.01") double slipRate)
        implements Effect {
    /**
     * Checked friction.
     *
     * @throws IllegalArgumentException if a number is negative, not finite, or the slip rate 0
     */
    public PivotFriction {
        Domain.atLeast0("a pivot friction", "coulomb torque", coulomb, "N m");
        Domain.atLeast0("a pivot friction", "viscous coefficient", viscous, "N m s/rad");
        Domain.above0("a pivot friction", "slip rate", slipRate, "rad/s");
    }

    /** Dry friction turns round as soon as the body does. */
    @Override
    public boolean isAbrupt() {
        return coulomb > 0;
    }

    @Override
    public BlockEffect layOut(List<List<Effect>> bySlot, Surroundings around) {
        return Layers.of(bySlot, PivotFrictionBlock::new);
    }
}
