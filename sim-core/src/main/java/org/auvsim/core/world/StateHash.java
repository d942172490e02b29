package org.auvsim.core.world;

import org.auvsim.core.entity.BodyState;
import org.auvsim.core.entity.WorldObject;
import org.auvsim.core.math.SplitMix64;

import java.util.List;

/**
 * A 64-bit digest of a world's time, ids and state: equal for equal bits, and for practical
 * purposes only then.
 */
final class StateHash {
    private StateHash() {}

    static long of(double time, List<WorldObject> objects, BodyState state) {
        long hash = mix(SplitMix64.STEP, Double.doubleToRawLongBits(time));
        for (WorldObject object : objects) {
            hash = mix(hash, object.id());
            for (int c = 0; c < BodyState.COLUMNS; c++) {
                hash = mix(hash, Double.doubleToRawLongBits(state.column(c)[object.slot()]));
            }
        }
        return hash;
    }

    private static long mix(long hash, long value) {
        return SplitMix64.mix(hash + SplitMix64.STEP + value);
    }
}
