package org.auvsim.core.effect;

import static org.auvsim.core.entity.MotionAxis.HEAVE;
import static org.auvsim.core.entity.MotionAxis.PITCH;
import static org.auvsim.core.entity.MotionAxis.ROLL;
import static org.auvsim.core.entity.MotionAxis.SURGE;
import static org.auvsim.core.entity.MotionAxis.SWAY;
import static org.auvsim.core.entity.MotionAxis.YAW;

import org.auvsim.core.description.Default;
import org.auvsim.core.description.Unit;
import org.auvsim.core.entity.BlockEffect;
import org.auvsim.core.entity.Domain;
import org.auvsim.core.entity.Effect;
import org.auvsim.core.entity.MotionAxis;
import org.auvsim.core.entity.Surroundings;
import org.auvsim.core.math.Vec3;

import java.util.List;

/**
 * Linear and quadratic damping by the water (Fossen 2021, section 6.4), of the velocity nu relative
 * to the water in body axes: tau_i = -sum over j of (a_ij + b_ij |nu_j|) nu_j. The diagonals of a
 * and b stand in the vectors, each body axis for itself; elements beside them in terms.
 *
 * @param linear a of surge, sway and heave (N s/m), none below 0
 * @param quadratic b of surge, sway and heave (N s^2/m^2), none below 0
 * @param angularLinear of roll, pitch and yaw (N m s/rad), none below 0
 * @param angularQuadratic of roll, pitch and yaw (N m s^2/rad^2), none below 0
 * @param term elements beside the diagonals; unlike those of added mass they have no mirror images
 */
public record Damping(
        @Unit("N s/m") @Default("0 0 0") Vec3 linear,
        @Unit("N s^2/m^2") @Default("0 0 0") Vec3 quadratic,
        @Unit("N m s/rad") @Default("0 0 0") Vec3 angularLinear,
        @Unit("N m s^2/rad^2") @Default("0 0 0") Vec3 angularQuadratic,
        List<DampingTerm> term)
        implements Effect {
    /**
     * Checked damping.
     *
     * @throws IllegalArgumentException if a coefficient is not finite, a term is stated twice, or
     *     some motion would be fed energy
     */
    public Damping {
        term = List.copyOf(term);
        requireDissipative("linear", linear, "N s/m", SURGE, SWAY, HEAVE);
        requireDissipative("quadratic", quadratic, "N s^2/m^2", SURGE, SWAY, HEAVE);
        requireDissipative("linear", angularLinear, "N m s/rad", ROLL, PITCH, YAW);
        requireDissipative("quadratic", angularQuadratic, "N m s^2/rad^2", ROLL, PITCH, YAW);
        DampingMatrix a = new DampingMatrix("linear", linear, angularLinear);
        DampingMatrix b = new DampingMatrix("quadratic", quadratic, angularQuadratic);
        for (DampingTerm t : term) {
            a.put(t.row(), t.column(), t.linear());
            b.put(t.row(), t.column(), t.quadratic());
        }
        a.requireDissipativeLinear();
        b.requireDissipativeQuadratic();
    }

    /** Damping of each axis for itself. */
    public Damping(Vec3 linear, Vec3 quadratic, Vec3 angularLinear, Vec3 angularQuadratic) {
        this(linear, quadratic, angularLinear, angularQuadratic, List.of());
    }

    private static void requireDissipative(
            String kind, Vec3 k, String unit, MotionAxis x, MotionAxis y, MotionAxis z) {
        Domain.atLeast0("damping", kind + " coefficient of " + x, k.x(), unit);
        Domain.atLeast0("damping", kind + " coefficient of " + y, k.y(), unit);
        Domain.atLeast0("damping", kind + " coefficient of " + z, k.z(), unit);
    }

    @Override
    public BlockEffect layOut(List<List<Effect>> bySlot, Surroundings around) {
        return new DampingBlock(bySlot);
    }
}
