package org.auvsim.core.field;

import org.auvsim.core.math.SplitMix64;

/** Numbers from a seed, the same ones on every machine ({@link SplitMix64}). */
final class Draw {
    private long state;

    Draw(long seed) {
        state = seed;
    }

    /** A number from 0 to below 1. */
    double next() {
        state += SplitMix64.STEP;
        return SplitMix64.unit(SplitMix64.mix(state));
    }
}
