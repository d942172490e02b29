package org.auvsim.experiments.bench;

import org.auvsim.core.world.World;

/** When a run is over. */
final class Clock {
    /** Sums of time steps round (s). */
    private static final double TOLERANCE = 1e-9;

    private Clock() {}

    static boolean isOver(World world, double until) {
        return world.time() >= until - TOLERANCE;
    }
}
