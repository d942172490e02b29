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
 * Dry friction of a body that slides on something that is not part of the world, as on a rail: F =
 * -mu m g v / max(|v|, s) at its origin. Below the slip speed s it falls to nothing in proportion
 * to v, as with {@link PivotFriction}: what should stick creeps.
 *
 * @param coefficient mu, 0 or more
 * @param acceleration g by which the body presses on what it slides on (m/s^2), 0 or more
 * @param slipSpeed s (m/s), above 0; with time steps of h, mu g h or more
 */
public record CoulombFriction(
        @Default("0.0") double coefficient,
        @Unit("m/s^2") @Default("9.80665") double acceleration,
        @Unit("m/s") @Default("0.01") double slipSpeed)
        implements Effect {
    /**
     * Checked friction.
     *
     * @throws IllegalArgumentException if a number is negative, not finite, or the slip speed 0
     */
    public CoulombFriction {
        Domain.atLeast0("a Coulomb friction", "coefficient", coefficient, "");
        Domain.atLeast0("a Coulomb friction", "acceleration", acceleration, "m/s^2");
        Domain.above0("a Coulomb friction", "slip speed", slipSpeed, "m/s");
    }

    @Override
    public boolean isAbrupt() {
        return coefficient > 0;
    }

    @Override
    public BlockEffect layOut(List<List<Effect>> bySlot, Surroundings around) {
        return OneByOne.stiff(bySlot, (effect, b, i) -> ((CoulombFriction) effect).add(b, i));
    }

    private void add(Block b, int i) {
        double x = b.vx[i];
        double y = b.vy[i];
        double z = b.vz[i];
        double most = coefficient * b.mass[i] * acceleration;
        double k = most / Math.max(Math.sqrt(x * x + y * y + z * z), slipSpeed);
        b.fx[i] -= k * x;
        b.fy[i] -= k * y;
        b.fz[i] -= k * z;
    }
}
