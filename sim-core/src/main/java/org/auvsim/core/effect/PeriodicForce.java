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
        implements SmoothForce {
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
    public Vec3 at(Vec3 place, double time) {
        double angle = angularFrequency * time;
        return sine.times(StrictMath.sin(angle)).plus(cosine.times(StrictMath.cos(angle)));
    }

    @Override
    public BlockEffect layOut(List<List<Effect>> bySlot, Surroundings around) {
        PeriodicForce[][] forces = new PeriodicForce[bySlot.size()][];
        for (int slot = 0; slot < forces.length; slot++) {
            forces[slot] = bySlot.get(slot).toArray(PeriodicForce[]::new);
        }
        return (PlainForce) block -> add(block, forces);
    }

    /** Bodies that follow each other often have the same frequency: that is worked out once. */
    private static void add(Block b, PeriodicForce[][] forces) {
        double omega = 0;
        double s = 0;
        double c = 1;
        for (int i = 0; i < b.count; i++) {
            for (PeriodicForce force : forces[b.slot(i)]) {
                if (force.angularFrequency != omega) {
                    omega = force.angularFrequency;
                    s = StrictMath.sin(omega * b.time);
                    c = StrictMath.cos(omega * b.time);
                }
                b.fx[i] += force.sine.x() * s + force.cosine.x() * c;
                b.fy[i] += force.sine.y() * s + force.cosine.y() * c;
                b.fz[i] += force.sine.z() * s + force.cosine.z() * c;
            }
        }
    }
}
