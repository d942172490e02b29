package org.auvsim.core.math;

import java.util.Arrays;

/**
 * Exponentials that were computed last: bodies side by side often ask for the same. Mutable, for
 * one thread; what is remembered is what {@link StrictMath#exp} gives, to the bit.
 */
public final class Exponentials {
    /** A power of 2. */
    private static final int PLACES = 256;

    private final double[] arguments = new double[PLACES];
    private final double[] values = new double[PLACES];

    /** Nothing is remembered yet. */
    public Exponentials() {
        Arrays.fill(arguments, Double.NaN);
    }

    /** e to the power of x. */
    public double exp(double x) {
        long bits = Double.doubleToRawLongBits(x) * 0x9E3779B97F4A7C15L;
        int place = (int) (bits >>> 56);
        if (arguments[place] != x) {
            arguments[place] = x;
            values[place] = StrictMath.exp(x);
        }
        return values[place];
    }
}
