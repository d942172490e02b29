package org.auvsim.experiments.thesis;

import org.auvsim.core.world.World;

import java.util.function.BooleanSupplier;

/** How long a world takes. */
public final class WallTime {
    private WallTime() {}

    /** Wall time (s) until a world has come to a world time (s), or until told to stop. */
    public static double of(World world, double until, BooleanSupplier stop) {
        long begin = System.nanoTime();
        while (world.time() < until && !stop.getAsBoolean()) {
            world.advanceTimestep();
        }
        return (System.nanoTime() - begin) * 1e-9;
    }
}
