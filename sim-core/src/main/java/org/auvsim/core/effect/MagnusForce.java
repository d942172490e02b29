package org.auvsim.core.effect;

import org.auvsim.core.description.Default;
import org.auvsim.core.description.Unit;
import org.auvsim.core.entity.BlockEffect;
import org.auvsim.core.entity.Domain;
import org.auvsim.core.entity.Effect;
import org.auvsim.core.entity.Surroundings;

import java.util.List;

/**
 * The sideways force on a body that spins in a stream: F = c w x (v - u), with the angular velocity
 * w and the velocity v - u through the water. For a sphere of radius R in water of density rho that
 * moves slowly, c = pi rho R^3 (Rubinow &amp; Keller, Journal of Fluid Mechanics 11, 1961).
 *
 * @param coefficient c (kg); below 0 for smooth balls near the drag crisis, which swerve the other
 *     way
 */
public record MagnusForce(@Unit("kg") @Default("0.0") double coefficient) implements Effect {
    /**
     * A checked force.
     *
     * @throws IllegalArgumentException if the coefficient is not finite
     */
    public MagnusForce {
        Domain.finite("a Magnus force", "coefficient", coefficient, "kg");
    }

    @Override
    public BlockEffect layOut(List<List<Effect>> bySlot, Surroundings around) {
        double[] coefficients = new double[bySlot.size()];
        for (int slot = 0; slot < coefficients.length; slot++) {
            for (Effect effect : bySlot.get(slot)) {
                coefficients[slot] += ((MagnusForce) effect).coefficient();
            }
        }
        return new MagnusBlock(coefficients);
    }
}
