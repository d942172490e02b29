package org.auvsim.core.field;

import org.auvsim.core.description.Default;
import org.auvsim.core.description.Unit;
import org.auvsim.core.entity.Block;
import org.auvsim.core.entity.Current;
import org.auvsim.core.entity.Domain;
import org.auvsim.core.math.Vec3;

import java.util.OptionalDouble;

/**
 * A sea of long crests: many regular waves ({@link WaveTrains}) of one direction, whose heights
 * follow the spectrum of JONSWAP, or with gamma 1 that of Pierson and Moskowitz, and whose phases
 * are drawn from a seed.
 *
 * @param significantHeight Hs (m), 0 or more: four times the standard deviation of the surface
 * @param peakPeriod Tp (s), above 0: of the frequency with most energy
 * @param gamma by how much the peak is enhanced, 1 to 10; 3.3 on the average in JONSWAP
 * @param direction to which the waves run (rad from the world's x to y)
 * @param components number of regular waves, 1 to 1000; each costs its share of time
 * @param depth of the water (m), above 0; empty: deep water
 * @param surface height of still water (m, world)
 */
public record IrregularWaves(
        long id,
        String name,
        @Unit("m") double significantHeight,
        @Unit("s") double peakPeriod,
        @Default("1.0") double gamma,
        @Unit("rad") @Default("0.0") double direction,
        @Default("40") int components,
        @Default("1") long seed,
        @Unit("m") OptionalDouble depth,
        @Unit("m") @Default("0.0") double surface)
        implements Current {
    /** The most components. */
    private static final int MOST = 1000;

    /**
     * A checked sea.
     *
     * @throws IllegalArgumentException if a number is out of its range
     */
    public IrregularWaves {
        String waves = "waves '" + name + "'";
        Domain.atLeast0(waves, "significant height", significantHeight, "m");
        Domain.above0(waves, "peak period", peakPeriod, "s");
        Domain.within(waves, "gamma", 1, 10, gamma, "");
        Domain.finite(waves, "direction", direction, "rad");
        Domain.within(waves, "number of components", 1, MOST, components, "");
        depth.ifPresent(d -> Domain.above0(waves, "depth", d, "m"));
        Domain.finite(waves, "surface", surface, "m");
        double highest = 2 * AiryWave.highest(peakPeriod, depth);
        if (significantHeight > highest) {
            throw new IllegalArgumentException(
                    "the significant height of %s must be %s m at most, as a wave of the peak period that is steeper breaks, but is %s m"
                            .formatted(waves, highest, significantHeight));
        }
    }

    @Override
    public Current prepared() {
        Draw draw = new Draw(seed);
        Spectrum spectrum = new Spectrum(2 * Math.PI / peakPeriod, gamma);
        double[] omega = spectrum.frequencies(components, draw);
        double[] phase = new double[components];
        for (int n = 0; n < components; n++) {
            phase[n] = 2 * Math.PI * draw.next();
        }
        return new WaveTrains(
                id,
                name,
                new WaveTrains.Water(surface, depth.orElse(Double.POSITIVE_INFINITY)),
                direction,
                spectrum.amplitudes(omega, significantHeight),
                omega,
                phase);
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
