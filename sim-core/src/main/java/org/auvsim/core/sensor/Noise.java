package org.auvsim.core.sensor;

import org.auvsim.core.math.SplitMix64;

/**
 * The random numbers of one sample of one sensor. Each is a function of seed, object, sensor,
 * channel and sample number, and of nothing that came before: a counter-based generator (Salmon et
 * al., SC 2011) with the output function of SplitMix64 (Steele, Lea and Flood, OOPSLA 2014).
 */
public final class Noise {
    private static final int WALKS = 1 << 16;
    private static final int WALKS_BACK = 1 << 17;
    private static final int COINS = 1 << 18;

    private final long key;
    private final long sample;
    private final double rate;
    private final Walks walks;

    private Noise(long key, long sample, double rate, Walks walks) {
        this.key = key;
        this.sample = sample;
        this.rate = rate;
        this.walks = walks;
    }

    /** The noise of sample {@code k} of a sensor of this name in the object of an id. */
    public static Noise of(long objectId, String sensor, Sampling sampling, long k) {
        return new Noise(key(sampling.seed(), objectId, sensor), k, sampling.rate(), new Walks());
    }

    /** The noise of event {@code k} at a component of this name in the object of an id. */
    public static Noise of(long seed, long objectId, String component, long k) {
        return new Noise(key(seed, objectId, component), k, 1, new Walks());
    }

    /** The same as a new one for sample {@code k} of the same sensor, but faster in its walks. */
    public Noise at(long k) {
        return new Noise(key, k, rate, walks);
    }

    private static long key(long seed, long objectId, String component) {
        return SplitMix64.mix(
                SplitMix64.mix(SplitMix64.mix(seed + SplitMix64.STEP) + objectId)
                        + component.hashCode());
    }

    /** A number with normal distribution, mean 0 and variance 1; one for each channel. */
    public double gaussian(int channel) {
        return gaussian(channel, sample);
    }

    /** A number with uniform distribution in [0, 1); one for each channel. */
    public double uniform(int channel) {
        return SplitMix64.unit(bits(COINS + channel, sample));
    }

    /**
     * A standard Wiener process at the sample's time t: mean 0, variance |t| (s), independent
     * increments, 0 at time 0.
     *
     * <p>It is found from its values at powers of two by bisection (Levy's construction), each
     * middle of two known values being their mean and a number of its own: some 2 log2 k numbers,
     * of which one or two are new where the samples before were asked for.
     */
    public double walk(int channel) {
        if (sample == 0) {
            return 0;
        }
        int stream = (sample < 0 ? WALKS_BACK : WALKS) + channel;
        return steps(stream, Math.abs(sample)) / Math.sqrt(rate);
    }

    /** The sum of {@code n} independent steps of variance 1. */
    private double steps(int stream, long n) {
        Walks.Walk walk = walks.of(stream);
        int level = Long.SIZE - 1 - Long.numberOfLeadingZeros(n);
        long low = 1L << level;
        double atLow = atPower(walk, stream, level);
        if (low == n) {
            return atLow;
        }
        double atHigh = atPower(walk, stream, level + 1);
        while (low < n) {
            level--;
            long middle = low + (1L << level);
            double value = atMiddle(walk, stream, level, middle, atLow, atHigh);
            if (middle <= n) {
                low = middle;
                atLow = value;
            } else {
                atHigh = value;
            }
        }
        return atLow;
    }

    /** The walk at 2^level. */
    private double atPower(Walks.Walk walk, int stream, int level) {
        double value = 0;
        for (int j = 0; j <= level; j++) {
            double known = walk.atPower(j);
            double steps = j == 0 ? 1 : 1L << (j - 1);
            value =
                    Double.isNaN(known)
                            ? walk.keepAtPower(
                                    j, value + Math.sqrt(steps) * gaussian(stream, 1L << j))
                            : known;
        }
        return value;
    }

    /** The walk 2^level steps from either end of an interval at whose ends it is known. */
    private double atMiddle(
            Walks.Walk walk, int stream, int level, long middle, double atLow, double atHigh) {
        if (walk.knows(level, middle)) {
            return walk.atMiddle(level);
        }
        double spread = Math.sqrt((1L << level) * 0.5);
        double value = (atLow + atHigh) / 2 + spread * gaussian(stream, middle);
        return walk.keepAtMiddle(level, middle, value);
    }

    /** Number {@code i} of a stream (Box and Muller 1958). */
    private double gaussian(int stream, long i) {
        double u = 1 - SplitMix64.unit(bits(stream, 2 * i));
        double angle = 2 * Math.PI * SplitMix64.unit(bits(stream, 2 * i + 1));
        return Math.sqrt(-2 * StrictMath.log(u)) * StrictMath.cos(angle);
    }

    /** Output {@code i} of SplitMix64 whose state began at the stream's key. */
    private long bits(int stream, long i) {
        return SplitMix64.mix(
                SplitMix64.mix(key + stream * SplitMix64.STEP) + (i + 1) * SplitMix64.STEP);
    }
}
