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
 * A force at the origin that comes again and again, the same everywhere: F = sine sin(omega t) +
 * cosine cos(omega t), with the world's time t. Two parts that are in line swing along a line, with
 * a phase; others go round an ellipse.
 *
 * @param sine its part that is 0 at time 0 (N, world)
 * @param cosine its part that is greatest at time 0 (N, world)
 * @param angularFrequency omega (rad/s), 0 or more
 */
public record PeriodicForce(
        @Unit("N") @Default("0 0 0") Vec3 sine,
        @Unit("N") @Default("0 0 0") Vec3 cosine,
        @Unit("rad/s") @Default("1.0") double angularFrequency)
        implements Effect {
    /**
     * A checked force.
     *
     * @throws IllegalArgumentException if a number is not finite, or the frequency negative
     */
    public PeriodicForce {
        Domain.finite("a periodic force", "sine", sine, "N");
        Domain.finite("a periodic force", "cosine", cosine, "N");
        Domain.atLeast0("a periodic force", "angular frequency", angularFrequency, "rad/s");
    }

    @Override
    public BlockEffect layOut(List<List<Effect>> bySlot, Surroundings around) {
        return OneByOne.mild(bySlot, (effect, b, i) -> ((PeriodicForce) effect).add(b, i));
    }

    private void add(Block b, int i) {
        double s = StrictMath.sin(angularFrequency * b.time);
        double c = StrictMath.cos(angularFrequency * b.time);
        b.fx[i] += sine.x() * s + cosine.x() * c;
        b.fy[i] += sine.y() * s + cosine.y() * c;
        b.fz[i] += sine.z() * s + cosine.z() * c;
    }
}
