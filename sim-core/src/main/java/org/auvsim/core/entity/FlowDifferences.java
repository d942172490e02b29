package org.auvsim.core.entity;

import org.auvsim.core.math.Vec3;

/** The derivatives of a current by central differences of its values. */
final class FlowDifferences {
    /** Half the distance (m) and time (s): errors of their square, rounding below 1e-12/1e-4. */
    private static final double STEP = 1e-4;

    private FlowDifferences() {}

    /** Adds those at the place of body {@code i} to the block's. */
    static void add(Current current, Block b, int i, Vec3 place) {
        add(
                b,
                i,
                0,
                1,
                current.valueAt(place, b.time + STEP),
                current.valueAt(place, b.time - STEP));
        for (int column = 0; column < 3; column++) {
            Vec3 aside =
                    new Vec3(
                            column == 0 ? STEP : 0, column == 1 ? STEP : 0, column == 2 ? STEP : 0);
            add(
                    b,
                    i,
                    3 + column,
                    3,
                    current.valueAt(place.plus(aside), b.time),
                    current.valueAt(place.minus(aside), b.time));
        }
    }

    private static void add(Block b, int i, int first, int stride, Vec3 after, Vec3 before) {
        Vec3 change = after.minus(before).times(0.5 / STEP);
        b.flow[first][i] += change.x();
        b.flow[first + stride][i] += change.y();
        b.flow[first + 2 * stride][i] += change.z();
    }
}
