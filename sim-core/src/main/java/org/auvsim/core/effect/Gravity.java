package org.auvsim.core.effect;

import org.auvsim.core.description.Default;
import org.auvsim.core.description.Unit;
import org.auvsim.core.entity.BlockEffect;
import org.auvsim.core.entity.Domain;
import org.auvsim.core.entity.Effect;
import org.auvsim.core.entity.Surroundings;

import java.util.List;

/**
 * Weight: the force mass times {@code acceleration} straight down, at the centre of mass.
 *
 * @param acceleration (m/s^2), 0 or more; standard gravity is 9.80665 (CGPM 1901)
 */
public record Gravity(@Unit("m/s^2") @Default("9.80665") double acceleration) implements Effect {
    /**
     * Checked gravity.
     *
     * @throws IllegalArgumentException if the acceleration is negative or not finite
     */
    public Gravity {
        Domain.atLeast0("gravity", "acceleration", acceleration, "m/s^2");
    }

    @Override
    public BlockEffect layOut(List<List<Effect>> bySlot, Surroundings around) {
        double[] downward = new double[bySlot.size()];
        for (int slot = 0; slot < downward.length; slot++) {
            for (Effect effect : bySlot.get(slot)) {
                downward[slot] += ((Gravity) effect).acceleration();
            }
        }
        return new GravityBlock(downward);
    }
}
