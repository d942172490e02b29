package org.auvsim.core.sensor;

/**
 * The random numbers of one sample of one sensor. Each is a function of seed, object, sensor,
 * channel and sample number, and of nothing that came before: a counter-based generator (Salmon et
 * al., SC 2011) with the output function of SplitMix64 (Steele, Lea and Flood, OOPSLA 2014).
 */
public final class Noise {
    private static final long GOLDEN = 0x9E3779B97F4A7C15L;
    private static final int WALKS = 1 << 16;
    private static final int WALKS_BACK = 1 << 17;
    private static final int COINS = 1 << 18;

    private final long key;
    private final long sample;
    private final double rate;

    private Noise(long key, long sample, double rate) {
        this.key = key;
        this.sample = sample;
        this.rate = rate;
    }

    /** The noise of sample {@code k} of a sensor of this name in the object of an id. */
    public static Noise of(long objectId, String sensor, Sampling sampling, long k) {
        return new Noise(key(sampling.seed(), objectId, sensor), k, sampling.rate());
    }

    /** The noise of event {@code k} at a component of this name in the object of an id. */
    public static Noise of(long seed, long objectId, String component, long k) {
        return new Noise(key(seed, objectId, component), k, 1);
    }

    private static long key(long seed, long objectId, String component) {
        return mix(mix(mix(seed + GOLDEN) + objectId) + component.hashCode());
    }

    /** A number with normal distribution, mean 0 and variance 1; one for each channel. */
    public double gaussian(int channel) {
        return gaussian(channel, sample);
    }

    /** A number with uniform distribution in [0, 1); one for each channel. */
    public double uniform(int channel) {
        return unit(bits(COINS + channel, sample));
    }

    /**
     * A standard Wiener process at the sample's time t: mean 0, variance |t| (s), independent
     * increments, 0 at time 0.
     *
     * <p>It is found from its values at powers of two by bisection (Levy's construction), each
     * middle of two known values being their mean and a number of its own: some 2 log2 k numbers,
     * whatever was read before.
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
        long low = 1;
        double atLow = gaussian(stream, 1);
        while (2 * low <= n) {
            atLow += Math.sqrt((double) low) * gaussian(stream, 2 * low);
            low *= 2;
        }
        long high = 2 * low;
        double atHigh = low == n ? atLow : atLow + Math.sqrt((double) low) * gaussian(stream, high);
        while (low < n) {
            long middle = (low + high) / 2;
            double spread = Math.sqrt((high - low) * 0.25);
            double atMiddle = (atLow + atHigh) / 2 + spread * gaussian(stream, middle);
            if (middle <= n) {
                low = middle;
                atLow = atMiddle;
            } else {
                high = middle;
                atHigh = atMiddle;
            }
        }
        return atLow;
    }

    /** Number {@code i} of a stream (Box and Muller 1958). */
    private double gaussian(int stream, long i) {
        double u = 1 - unit(bits(stream, 2 * i));
        double angle = 2 * Math.PI * unit(bits(stream, 2 * i + 1));
        return Math.sqrt(-2 * StrictMath.log(u)) * StrictMath.cos(angle);
    }

    private static double unit(long bits) {
        return (bits >>> 11) * 0x1p-53;
    }

    /** Output {@code i} of SplitMix64 whose state began at the stream's key. */
    private long bits(int stream, long i) {
        return mix(mix(key + stream * GOLDEN) + (i + 1) * GOLDEN);
    }

    private static long mix(long z) {
        long a = (z ^ (z >>> 30)) * 0xBF58476D1CE4E5B9L;
        long b = (a ^ (a >>> 27)) * 0x94D049BB133111EBL;
        return b ^ (b >>> 31);
    }
}
