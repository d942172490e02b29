package org.auvsim.core.field;

import org.auvsim.core.description.Default;
import org.auvsim.core.description.Unit;
import org.auvsim.core.entity.Block;
import org.auvsim.core.entity.Current;
import org.auvsim.core.entity.Domain;
import org.auvsim.core.math.Vec3;

/**
 * Water that swings everywhere in step, as a tide does: u = mean + amplitude sin(2 pi t / period +
 * phase).
 *
 * @param mean velocity (m/s)
 * @param amplitude of the velocity (m/s)
 * @param period (s), above 0
 * @param phase at the world's time 0 (rad)
 */
public record OscillatingCurrent(
        long id,
        String name,
        @Unit("m/s") @Default("0 0 0") Vec3 mean,
        @Unit("m/s") Vec3 amplitude,
        @Unit("s") double period,
        @Unit("rad") @Default("0.0") double phase)
        implements Current {
    /**
     * A checked current.
     *
     * @throws IllegalArgumentException if a number is not finite, or the period not above 0
     */
    public OscillatingCurrent {
        String current = "current '" + name + "'";
        Domain.finite(current, "mean", mean, "m/s");
        Domain.finite(current, "amplitude", amplitude, "m/s");
        Domain.above0(current, "period", period, "s");
        Domain.finite(current, "phase", phase, "rad");
    }

    @Override
    public Vec3 valueAt(Vec3 position, double time) {
        return mean.plus(amplitude.times(StrictMath.sin(angle(time))));
    }

    private double angle(double time) {
        return 2 * Math.PI * (time / period) + phase;
    }

    @Override
    public void addTo(Block b) {
        double swing = StrictMath.sin(angle(b.time));
        double change = 2 * Math.PI / period * StrictMath.cos(angle(b.time));
        add(b, b.ux, mean.x() + amplitude.x() * swing, b.flow[0], amplitude.x() * change);
        add(b, b.uy, mean.y() + amplitude.y() * swing, b.flow[1], amplitude.y() * change);
        add(b, b.uz, mean.z() + amplitude.z() * swing, b.flow[2], amplitude.z() * change);
    }

    private static void add(Block b, double[] to, double u, double[] rate, double acceleration) {
        for (int i = 0; i < b.count; i++) {
            to[i] += u;
            rate[i] += acceleration;
        }
    }
}
