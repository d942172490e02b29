package org.auvsim.core.effect;

import org.auvsim.core.description.Default;
import org.auvsim.core.description.Unit;
import org.auvsim.core.entity.Block;
import org.auvsim.core.entity.BlockEffect;
import org.auvsim.core.entity.Domain;
import org.auvsim.core.entity.Effect;
import org.auvsim.core.entity.Surroundings;

import java.util.List;

/**
 * Drag that is the same in all directions, of the velocity v relative to the water: F = -(c + k
 * |v|) v, and of turning: T = -d w. Negative numbers take away from what other effects do.
 *
 * @param linear c (N s/m)
 * @param quadratic k (N s^2/m^2)
 * @param angular d (N m s/rad)
 */
public record IsotropicDrag(
        @Unit("N s/m") @Default("0.0") double linear,
        @Unit("N s^2/m^2") @Default("0.0") double quadratic,
        @Unit("N m s/rad") @Default("0.0") double angular)
        implements Effect {
    /**
     * Checked drag.
     *
     * @throws IllegalArgumentException if a coefficient is not finite
     */
    public IsotropicDrag {
        Domain.finite("isotropic drag", "linear", linear, "N s/m");
        Domain.finite("isotropic drag", "quadratic", quadratic, "N s^2/m^2");
        Domain.finite("isotropic drag", "angular", angular, "N m s/rad");
    }

    @Override
    public BlockEffect layOut(List<List<Effect>> bySlot, Surroundings around) {
        double[] c = new double[bySlot.size()];
        double[] k = new double[bySlot.size()];
        double[] d = new double[bySlot.size()];
        for (int slot = 0; slot < c.length; slot++) {
            for (Effect effect : bySlot.get(slot)) {
                IsotropicDrag drag = (IsotropicDrag) effect;
                c[slot] += drag.linear;
                k[slot] += drag.quadratic;
                d[slot] += drag.angular;
            }
        }
        return block -> add(block, c, k, d);
    }

    private static void add(Block b, double[] c, double[] k, double[] d) {
        for (int i = 0; i < b.count; i++) {
            int slot = b.slot(i);
            double x = b.vx[i] - b.ux[i];
            double y = b.vy[i] - b.uy[i];
            double z = b.vz[i] - b.uz[i];
            double factor = c[slot] + k[slot] * Math.sqrt(x * x + y * y + z * z);
            b.fx[i] -= factor * x;
            b.fy[i] -= factor * y;
            b.fz[i] -= factor * z;
            b.tx[i] -= d[slot] * b.wx[i];
            b.ty[i] -= d[slot] * b.wy[i];
            b.tz[i] -= d[slot] * b.wz[i];
        }
    }
}
