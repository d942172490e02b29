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
     * @throws IllegalArgumentException if one is stated twice
     */
    public HydrodynamicDerivatives {
        derivative = List.copyOf(derivative);
        for (int i = 0; i < derivative.size(); i++) {
            for (Derivative other : derivative.subList(0, i)) {
                if (other.name().equals(derivative.get(i).name())) {
                    throw new IllegalArgumentException(
                            "the hydrodynamic derivative %s is stated twice, as %s and %s"
                                    .formatted(
                                            other.name(),
                                            other.value(),
                                            derivative.get(i).value()));
                }
            }
        }
    }

    @Override
    public BlockEffect layOut(List<List<Effect>> bySlot, Surroundings around) {
        return new DerivativesBlock(bySlot);
    }
}
