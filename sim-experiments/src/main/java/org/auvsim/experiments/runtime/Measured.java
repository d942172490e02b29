package org.auvsim.experiments.runtime;

import org.auvsim.core.step.EventStepper;
import org.auvsim.experiments.Conduct;
import org.auvsim.experiments.thesis.StageCost;
import org.auvsim.experiments.thesis.WallTime;
import org.auvsim.experiments.workload.Workload;

/**
 * What a number of bodies costs.
 *
 * @param snapshots operations and wall time with {@code SnapshotStepper}
 * @param eventSeconds wall time of the same world time with {@code EventStepper}
 */
record Measured(StageCost snapshots, double eventSeconds) {
    /** So often the wall time is taken; the shortest one counts. */
    static final int RUNS = 3;

    /** Measures over so many seconds of world time. */
    static Measured of(Workload workload, double seconds, Conduct conduct) {
        Measured best = once(workload, seconds, conduct);
        for (int run = 1; run < RUNS && !conduct.isStopped(); run++) {
            best = best.orFaster(once(workload, seconds, conduct));
        }
        return best;
    }

    private static Measured once(Workload workload, double seconds, Conduct conduct) {
        StageCost snapshots = StageCost.measure(workload, seconds, conduct.stop());
        double events =
                WallTime.of(
                        workload.world().stepper(EventStepper.standard()).build(),
                        seconds,
                        conduct.stop());
        return new Measured(snapshots, events);
    }

    private Measured orFaster(Measured other) {
        boolean isFaster = other.snapshots.wallSeconds() < snapshots.wallSeconds();
        return new Measured(
                isFaster ? other.snapshots : snapshots, Math.min(eventSeconds, other.eventSeconds));
    }

    int bodies() {
        return snapshots.bodies();
    }
}
