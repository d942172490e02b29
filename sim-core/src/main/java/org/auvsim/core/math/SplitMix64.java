package org.auvsim.core.math;

/**
 * The generator SplitMix64 (Steele, Lea &amp; Flood, Fast Splittable Pseudorandom Number
 * Generators, OOPSLA 2014), in parts: its state grows by {@link #STEP} each time, and the mixed
 * state is the output.
 */
public final class SplitMix64 {
    /** By which the state grows: 2^64 over the golden ratio, made odd. */
    public static final long STEP = 0x9E3779B97F4A7C15L;

    private SplitMix64() {}

    /** The output of a state: each of its bits depends on all of the state's. */
    public static long mix(long state) {
        long a = (state ^ (state >>> 30)) * 0xBF58476D1CE4E5B9L;
        long b = (a ^ (a >>> 27)) * 0x94D049BB133111EBL;
        return b ^ (b >>> 31);
    }

    /** An output as a number from 0 to below 1, of its upper 53 bits. */
    public static double unit(long output) {
        return (output >>> 11) * 0x1p-53;
    }
}
