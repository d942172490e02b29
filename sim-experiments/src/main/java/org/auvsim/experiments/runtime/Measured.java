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
    /** Measures over so many seconds of world time. */
    static Measured of(Workload workload, double seconds, Conduct conduct) {
        StageCost snapshots = StageCost.measure(workload, seconds, conduct.stop());
        double events =
                WallTime.of(
                        workload.world().stepper(EventStepper.standard()).build(),
                        seconds,
                        conduct.stop());
        return new Measured(snapshots, events);
    }

    int bodies() {
        return snapshots.bodies();
    }
}
