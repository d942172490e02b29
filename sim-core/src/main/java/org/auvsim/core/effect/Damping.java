package org.auvsim.core.effect;

import org.auvsim.core.description.Default;
import org.auvsim.core.description.Unit;
import org.auvsim.core.entity.BlockEffect;
import org.auvsim.core.entity.Effect;
import org.auvsim.core.entity.Surroundings;
import org.auvsim.core.math.Vec3;

import java.util.List;

/**
 * Linear and quadratic damping by the water, each body axis for itself (Fossen 2021, section 6.4):
 * F_i = -(a_i + b_i |v_i|) v_i with v the velocity relative to the water in body axes, and T_i in
 * the same way from the angular velocity.
 *
 * @param linear a of surge, sway and heave (N s/m), none below 0
 * @param quadratic b of surge, sway and heave (N s^2/m^2), none below 0
 * @param angularLinear of roll, pitch and yaw (N m s/rad), none below 0
 * @param angularQuadratic of roll, pitch and yaw (N m s^2/rad^2), none below 0
 */
public record Damping(
        @Unit("N s/m") @Default("0 0 0") Vec3 linear,
        @Unit("N s^2/m^2") @Default("0 0 0") Vec3 quadratic,
        @Unit("N m s/rad") @Default("0 0 0") Vec3 angularLinear,
        @Unit("N m s^2/rad^2") @Default("0 0 0") Vec3 angularQuadratic)
        implements Effect {
    /**
     * Checked damping.
     *
     * @throws IllegalArgumentException if a coefficient is negative, which would feed energy in, or
     *     not finite
     */
    public Damping {
        requireDissipative("linear", linear);
        requireDissipative("quadratic", quadratic);
        requireDissipative("angular linear", angularLinear);
        requireDissipative("angular quadratic", angularQuadratic);
    }

    private static void requireDissipative(String which, Vec3 k) {
        if (!k.isFinite() || !(k.x() >= 0 && k.y() >= 0 && k.z() >= 0)) {
            throw new IllegalArgumentException(
                    "the " + which + " damping coefficients must be 0 or more, but are " + k);
        }
    }

    @Override
    public BlockEffect layOut(List<List<Effect>> bySlot, Surroundings around) {
        return new DampingBlock(bySlot);
    }
}
