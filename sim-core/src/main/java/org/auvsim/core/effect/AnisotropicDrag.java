package org.auvsim.core.effect;

import org.auvsim.core.description.Default;
import org.auvsim.core.description.Unit;
import org.auvsim.core.entity.Block;
import org.auvsim.core.entity.BlockEffect;
import org.auvsim.core.entity.Domain;
import org.auvsim.core.entity.Effect;
import org.auvsim.core.entity.Surroundings;
import org.auvsim.core.math.Vec3;

import java.util.List;

/**
 * Quadratic drag along each body axis for itself: F_i = -k_i |v_i| v_i of the velocity v relative
 * to the water. Negative numbers take away from what other effects do.
 *
 * @param quadratic k (N s^2/m^2, body)
 */
public record AnisotropicDrag(@Unit("N s^2/m^2") @Default("0 0 0") Vec3 quadratic)
        implements Effect {
    /**
     * Checked drag.
     *
     * @throws IllegalArgumentException if a coefficient is not finite
     */
    public AnisotropicDrag {
        Domain.finite("anisotropic drag", "quadratic", quadratic, "N s^2/m^2");
    }

    @Override
    public BlockEffect layOut(List<List<Effect>> bySlot, Surroundings around) {
        double[][] k = new double[3][bySlot.size()];
        for (int slot = 0; slot < bySlot.size(); slot++) {
            for (Effect effect : bySlot.get(slot)) {
                Vec3 more = ((AnisotropicDrag) effect).quadratic;
                k[0][slot] += more.x();
                k[1][slot] += more.y();
                k[2][slot] += more.z();
            }
        }
        return new Along(k);
    }

    /** The drag of all bodies of a world, by axis and slot. */
    private static final class Along implements BlockEffect {
        private final double[][] k;

        Along(double[][] k) {
            this.k = k;
        }

        @Override
        public void add(Block b) {
            double[][] v = b.relativeVelocities();
            double[][] s = b.scratch;
            for (int axis = 0; axis < 3; axis++) {
                b.gather(k[axis], s[axis]);
                oppose(b.count, s[axis], v[axis]);
            }
            b.addToWorld(b.fx, b.fy, b.fz, s[0], s[1], s[2]);
        }

        private static void oppose(int count, double[] k, double[] v) {
            for (int i = 0; i < count; i++) {
                k[i] *= -Math.abs(v[i]) * v[i];
            }
        }

        @Override
        public boolean mayTurn() {
            return false;
        }
    }
}
