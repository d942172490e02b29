package org.auvsim.core.effect;

import org.auvsim.core.description.Default;
import org.auvsim.core.description.Unit;
import org.auvsim.core.entity.Block;
import org.auvsim.core.entity.BlockEffect;
import org.auvsim.core.entity.Domain;
import org.auvsim.core.entity.Effect;
import org.auvsim.core.entity.Surroundings;
import org.auvsim.core.math.Rise;
import org.auvsim.core.math.Vec3;

import java.util.List;

/**
 * An impulse on the origin at some time, spread over a short duration about it, as integrators take
 * forces: F = impulse (1 + cos(2 pi (t - at) / duration)) / duration.
 *
 * @param impulse (N s, world)
 * @param at its middle (s, the world's time)
 * @param duration (s), above 0; two time steps or more, or some of it is lost
 */
public record Kick(
        @Unit("N s") @Default("0 0 0") Vec3 impulse,
        @Unit("s") @Default("0.0") double at,
        @Unit("s") @Default("0.1") double duration)
        implements Effect {
    /**
     * A checked kick.
     *
     * @throws IllegalArgumentException if a number is not finite, or the duration not above 0
     */
    public Kick {
        Domain.finite("a kick", "impulse", impulse, "N s");
        Domain.finite("a kick", "time", at, "s");
        Domain.above0("a kick", "duration", duration, "s");
    }

    @Override
    public BlockEffect layOut(List<List<Effect>> bySlot, Surroundings around) {
        return OneByOne.mild(bySlot, (effect, b, i) -> ((Kick) effect).add(b, i));
    }

    @Override
    public boolean isAbrupt() {
        return true;
    }

    private void add(Block b, int i) {
        double slope = Rise.slope(b.time, at, duration);
        b.fx[i] += slope * impulse.x();
        b.fy[i] += slope * impulse.y();
        b.fz[i] += slope * impulse.z();
    }
}
