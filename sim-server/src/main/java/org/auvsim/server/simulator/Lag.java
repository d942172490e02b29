package org.auvsim.server.simulator;

import java.util.OptionalLong;

/** Counts by how many steps a simulator that is too slow falls behind, and says so at times. */
final class Lag {
    private static final long SHORTEST_SILENCE = 5_000_000_000L;

    private final Pace pace;
    private double skipped;
    private OptionalLong lastTold = OptionalLong.empty();

    Lag(Pace pace) {
        this.pace = pace;
    }

    /** By how many it has fallen behind more, if by any and it is time to say so. */
    OptionalLong skippedSteps(double worldTime, double timeStep) {
        skipped += pace.skipWhatIsLost(worldTime);
        long now = pace.now();
        boolean saidJustNow = lastTold.isPresent() && now - lastTold.getAsLong() < SHORTEST_SILENCE;
        if (skipped == 0 || saidJustNow) {
            return OptionalLong.empty();
        }
        long steps = Math.max(1, Math.round(skipped / timeStep));
        skipped = 0;
        lastTold = OptionalLong.of(now);
        return OptionalLong.of(steps);
    }
}
