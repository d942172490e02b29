package org.auvsim.core.effect;

import org.auvsim.core.description.Default;
import org.auvsim.core.description.Unit;
import org.auvsim.core.entity.Block;
import org.auvsim.core.entity.BlockEffect;
import org.auvsim.core.entity.BodyState;
import org.auvsim.core.entity.Domain;
import org.auvsim.core.entity.Effect;
import org.auvsim.core.entity.Surroundings;
import org.auvsim.core.math.Vec3;

import java.util.List;

/**
 * What regular waves push a body with, as far as it is horizontal and measured rather than
 * computed: F = a d sin(omega t - k d . p + phase) along the direction d to which they run, with
 * the place p of the origin and the world's time t. Waves in deep water have k = omega^2/g (Airy
 * 1845); with k = 0 the force is the same everywhere. {@link org.auvsim.core.field.AiryWave} is the
 * water's motion itself.
 *
 * @param amplitude a (N)
 * @param direction of d (rad from the world's x to y)
 * @param angularFrequency omega (rad/s), 0 or more
 * @param phase (rad)
 * @param waveNumber k (rad/m), 0 or more
 */
public record WaveForce(
        @Unit("N") @Default("0.0") double amplitude,
        @Unit("rad") @Default("0.0") double direction,
        @Unit("rad/s") @Default("1.0") double angularFrequency,
        @Unit("rad") @Default("0.0") double phase,
        @Unit("rad/m") @Default("0.0") double waveNumber)
        implements SmoothForce {
    /**
     * A checked force.
     *
     * @throws IllegalArgumentException if a number is not finite, or frequency or wave number
     *     negative
     */
    public WaveForce {
        Domain.finite("a wave force", "amplitude", amplitude, "N");
        Domain.finite("a wave force", "direction", direction, "rad");
        Domain.atLeast0("a wave force", "angular frequency", angularFrequency, "rad/s");
        Domain.finite("a wave force", "phase", phase, "rad");
        Domain.atLeast0("a wave force", "wave number", waveNumber, "rad/m");
    }

    @Override
    public boolean dependsOnPlace() {
        return waveNumber > 0;
    }

    @Override
    public Vec3 at(Vec3 place, double time) {
        Crests crests = new Crests(this);
        double force = crests.force(place.x(), place.y(), time);
        return new Vec3(force * crests.dx, force * crests.dy, 0);
    }

    @Override
    public BlockEffect layOut(List<List<Effect>> bySlot, Surroundings around) {
        Crests[][] crests = new Crests[bySlot.size()][];
        for (int slot = 0; slot < crests.length; slot++) {
            crests[slot] =
                    bySlot.get(slot).stream()
                            .map(effect -> new Crests((WaveForce) effect))
                            .toArray(Crests[]::new);
        }
        return (PlainForce) block -> add(block, crests);
    }

    private static void add(Block b, Crests[][] crests) {
        for (int i = 0; i < b.count; i++) {
            for (Crests of : crests[b.slot(i)]) {
                of.add(b, i);
            }
        }
    }

    /**
     * A wave and where it runs.
     *
     * @param dx cosine of its direction
     * @param dy sine
     */
    private record Crests(WaveForce of, double dx, double dy) {
        Crests(WaveForce of) {
            this(of, StrictMath.cos(of.direction), StrictMath.sin(of.direction));
        }

        void add(Block b, int i) {
            double force = force(b.state[BodyState.X][i], b.state[BodyState.Y][i], b.time);
            b.fx[i] += force * dx;
            b.fy[i] += force * dy;
        }

        private double force(double x, double y, double time) {
            double way = dx * x + dy * y;
            double angle = of.angularFrequency * time - of.waveNumber * way + of.phase;
            return of.amplitude * StrictMath.sin(angle);
        }
    }
}
