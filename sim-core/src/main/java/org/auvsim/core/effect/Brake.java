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
 * Brings a body to rest in the world, as a vehicle does that keeps its station: F = -f v / max(|v|,
 * s) at its origin, and about each body axis tau_i = -t_i w_i / max(|w|, r). Above the slip speed s
 * and the slip rate r it is of constant size, below it falls to nothing in proportion, so that the
 * body comes to rest without trembling: {@link PivotFriction} tells of the same. A constant force
 * smaller than f that goes on acting makes the body creep, at s times its share of f; a larger one
 * is not held.
 *
 * @param force f (N), 0 or more
 * @param torque t_i about the body's axes (N m), none below 0
 * @param slipSpeed s (m/s), above 0; with time steps of h and a mass m, f h / m or more
 * @param slipRate r (rad/s), above 0; with a moment of inertia I_i, t_i h / I_i or more
 */
public record Brake(
        @Unit("N") double force,
        @Unit("N m") @Default("0 0 0") Vec3 torque,
        @Unit("m/s") @Default("0.05") double slipSpeed,
        @Unit("rad/s") @Default("0.05") double slipRate)
        implements Effect {
    /**
     * A checked brake.
     *
     * @throws IllegalArgumentException if a number is negative, not finite, or a slip 0
     */
    public Brake {
        Domain.atLeast0("a brake", "force", force, "N");
        Domain.atLeast0("a brake", "torque about x", torque.x(), "N m");
        Domain.atLeast0("a brake", "torque about y", torque.y(), "N m");
        Domain.atLeast0("a brake", "torque about z", torque.z(), "N m");
        Domain.above0("a brake", "slip speed", slipSpeed, "m/s");
        Domain.above0("a brake", "slip rate", slipRate, "rad/s");
    }

    @Override
    public BlockEffect layOut(List<List<Effect>> bySlot, Surroundings around) {
        return Layers.of(bySlot, BrakeBlock::new);
    }

    /** It holds the body where it is. */
    @Override
    public boolean dependsOnPlace() {
        return true;
    }
}
