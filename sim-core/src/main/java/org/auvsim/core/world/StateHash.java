package org.auvsim.core.world;

import org.auvsim.core.entity.BodyState;
import org.auvsim.core.entity.WorldObject;

import java.util.List;

/**
 * A 64-bit digest of a world's time, ids and state: equal for equal bits, and for practical
 * purposes only then.
 */
final class StateHash {
    private StateHash() {}

    static long of(double time, List<WorldObject> objects, BodyState state) {
        long hash = mix(0x9E3779B97F4A7C15L, Double.doubleToRawLongBits(time));
        for (WorldObject object : objects) {
            hash = mix(hash, object.id());
            for (int c = 0; c < BodyState.COLUMNS; c++) {
                hash = mix(hash, Double.doubleToRawLongBits(state.column(c)[object.slot()]));
            }
        }
        return hash;
    }

    /** The finalizer of SplitMix64 (Steele, Lea &amp; Flood, OOPSLA 2014) over the running sum. */
    private static long mix(long hash, long value) {
        long z = hash + 0x9E3779B97F4A7C15L + value;
        z = (z ^ (z >>> 30)) * 0xBF58476D1CE4E5B9L;
        z = (z ^ (z >>> 27)) * 0x94D049BB133111EBL;
        return z ^ (z >>> 31);
    }
}
