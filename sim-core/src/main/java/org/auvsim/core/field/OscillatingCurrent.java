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
        for (int i = 0; i < b.count; i++) {
            add(b, i, swing, change);
        }
    }

    @Override
    public void addTo(Block b, int i) {
        double swing = StrictMath.sin(angle(b.time));
        add(b, i, swing, 2 * Math.PI / period * StrictMath.cos(angle(b.time)));
    }

    private void add(Block b, int i, double swing, double change) {
        b.ux[i] += mean.x() + amplitude.x() * swing;
        b.uy[i] += mean.y() + amplitude.y() * swing;
        b.uz[i] += mean.z() + amplitude.z() * swing;
        b.flow[0][i] += amplitude.x() * change;
        b.flow[1][i] += amplitude.y() * change;
        b.flow[2][i] += amplitude.z() * change;
    }
}
