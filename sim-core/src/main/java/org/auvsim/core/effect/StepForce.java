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
 * A force at the origin from some time on, as of something that got caught. It rises within a short
 * time about that instant: a jump inside a time step would be integrated wrongly, and the velocity
 * after a rise is the same.
 *
 * @param force when it has risen (N, world)
 * @param from the middle of the rise (s, the world's time)
 * @param rise its duration (s), 0 or more; two time steps or more are integrated exactly
 */
public record StepForce(
        @Unit("N") @Default("0 0 0") Vec3 force,
        @Unit("s") @Default("0.0") double from,
        @Unit("s") @Default("0.1") double rise)
        implements Effect {
    /**
     * A checked force.
     *
     * @throws IllegalArgumentException if a number is not finite, or the rise negative
     */
    public StepForce {
        Domain.finite("a step force", "force", force, "N");
        Domain.finite("a step force", "time", from, "s");
        Domain.atLeast0("a step force", "rise", rise, "s");
    }

    @Override
    public BlockEffect layOut(List<List<Effect>> bySlot, Surroundings around) {
        return OneByOne.mild(bySlot, (effect, b, i) -> ((StepForce) effect).add(b, i));
    }

    @Override
    public boolean isAbrupt() {
        return true;
    }

    private void add(Block b, int i) {
        double share = Rise.share(b.time, from, rise);
        b.fx[i] += share * force.x();
        b.fy[i] += share * force.y();
        b.fz[i] += share * force.z();
    }
}
