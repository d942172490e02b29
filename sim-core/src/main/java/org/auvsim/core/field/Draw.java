package org.auvsim.core.field;

/**
 * Numbers from a seed, the same ones on every machine: SplitMix64 (Steele, Lea &amp; Flood, Fast
 * Splittable Pseudorandom Number Generators, OOPSLA 2014).
 */
final class Draw {
    private long state;

    Draw(long seed) {
        state = seed;
    }

    /** A number from 0 to below 1. */
    double next() {
        state += 0x9E3779B97F4A7C15L;
        long z = (state ^ (state >>> 30)) * 0xBF58476D1CE4E5B9L;
        z = (z ^ (z >>> 27)) * 0x94D049BB133111EBL;
        return (double) ((z ^ (z >>> 31)) >>> 11) * 0x1p-53;
    }
}
