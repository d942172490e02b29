package org.auvsim.core.field;

import org.auvsim.core.description.Default;
import org.auvsim.core.description.Unit;
import org.auvsim.core.entity.Block;
import org.auvsim.core.entity.Current;
import org.auvsim.core.entity.Domain;
import org.auvsim.core.math.Vec3;

import java.util.OptionalDouble;

/**
 * A regular wave of small height (Airy 1845; {@link WaveTrains} has its equations): how it moves
 * the water, and how it raises the surface.
 *
 * @param amplitude half its height (m), 0 or more, below where it would break
 * @param period (s), above 0
 * @param direction to which it runs (rad from the world's x to y)
 * @param phase of the crest at the world's origin and time 0 (rad)
 * @param depth of the water (m), above 0; empty: deep water
 * @param surface height of still water (m, world)
 */
public record AiryWave(
        long id,
        String name,
        @Unit("m") double amplitude,
        @Unit("s") double period,
        @Unit("rad") @Default("0.0") double direction,
        @Unit("rad") @Default("0.0") double phase,
        @Unit("m") OptionalDouble depth,
        @Unit("m") @Default("0.0") double surface)
        implements Current {
    /** Height by length of the steepest wave in deep water (Miche 1944). */
    private static final double STEEPEST = 0.142;

    /**
     * A checked wave.
     *
     * @throws IllegalArgumentException if a number is out of its range, or the wave so steep that
     *     it breaks
     */
    public AiryWave {
        String wave = "wave '" + name + "'";
        Domain.atLeast0(wave, "amplitude", amplitude, "m");
        Domain.above0(wave, "period", period, "s");
        Domain.finite(wave, "direction", direction, "rad");
        Domain.finite(wave, "phase", phase, "rad");
        depth.ifPresent(d -> Domain.above0(wave, "depth", d, "m"));
        Domain.finite(wave, "surface", surface, "m");
        double highest = highest(period, depth);
        if (amplitude > highest) {
            throw new IllegalArgumentException(
                    "the amplitude of %s must be %s m at most, as a steeper one breaks, but is %s m"
                            .formatted(wave, highest, amplitude));
        }
    }

    /** The amplitude (m) from which on it breaks: Miche's limit. */
    static double highest(double period, OptionalDouble depth) {
        double h = depth.orElse(Double.POSITIVE_INFINITY);
        double k = Dispersion.wavenumber(2 * Math.PI / period, h);
        return STEEPEST * Math.PI / k * StrictMath.tanh(k * h);
    }

    @Override
    public Current prepared() {
        return new WaveTrains(
                id,
                name,
                new WaveTrains.Water(surface, depth.orElse(Double.POSITIVE_INFINITY)),
                direction,
                new double[] {amplitude},
                new double[] {2 * Math.PI / period},
                new double[] {phase});
    }

    @Override
    public Vec3 valueAt(Vec3 position, double time) {
        return prepared().valueAt(position, time);
    }

    @Override
    public double elevation(double x, double y, double time) {
        return prepared().elevation(x, y, time);
    }

    @Override
    public void addTo(Block block) {
        prepared().addTo(block);
    }
}
