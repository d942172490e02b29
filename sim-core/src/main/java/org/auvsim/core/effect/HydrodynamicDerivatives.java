package org.auvsim.core.effect;

import org.auvsim.core.description.Default;
import org.auvsim.core.entity.BlockEffect;
import org.auvsim.core.entity.Effect;
import org.auvsim.core.entity.Surroundings;

import java.util.List;

/**
 * Forces and torques of the water as published for slender bodies: sums of coefficients times
 * products of velocities relative to the water, in body axes. Body lift and cross-flow drag come so
 * (Prestero 2001, chapter 4; Fossen 2021, chapter 8). Where added mass is stated, too, the parts
 * that come from it (Munk and Coriolis terms) must not stand here again.
 *
 * @param axes in which the derivatives are given
 */
public record HydrodynamicDerivatives(
        @Default("FLU") ReferenceAxes axes, List<Derivative> derivative) implements Effect {
    /**
     * Checked derivatives.
     *
     * @throws IllegalArgumentException if there is none, or two are the same term
     */
    public HydrodynamicDerivatives {
        derivative = List.copyOf(derivative);
        if (derivative.isEmpty()) {
            throw new IllegalArgumentException(
                    "the list of hydrodynamic derivatives must have at least one, but has 0");
        }
        for (int i = 0; i < derivative.size(); i++) {
            for (Derivative other : derivative.subList(0, i)) {
                Derivative own = derivative.get(i);
                if (other.form().equals(own.form())) {
                    throw new IllegalArgumentException(
                            ("the hydrodynamic derivatives %s (%s) and %s (%s) are one term that"
                                            + " is stated twice; leave one of them")
                                    .formatted(
                                            other.name(), other.value(), own.name(), own.value()));
                }
            }
        }
    }

    @Override
    public BlockEffect layOut(List<List<Effect>> bySlot, Surroundings around) {
        return new DerivativesBlock(bySlot);
    }
}
