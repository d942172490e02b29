package org.auvsim.experiments.thesis;

import org.auvsim.core.step.SnapshotStepper;
import org.auvsim.core.world.World;
import org.auvsim.experiments.workload.Workload;

import java.util.function.BooleanSupplier;

/**
 * What a world of so many bodies costs with the thesis' stages.
 *
 * @param restricter operations over {@value #ADVANCEMENTS} advancements, and likewise
 * @param partitioner operations likewise
 * @param finder operations likewise
 * @param wallSeconds wall time of {@value #WORLD_SECONDS} s of world time
 */
public record StageCost(
        int bodies, long restricter, long partitioner, long finder, double wallSeconds) {
    /** The advancements of a world over which the thesis counts. */
    public static final int ADVANCEMENTS = 100;

    /** The world time (s) over which the thesis takes the real time. */
    public static final double WORLD_SECONDS = 120;

    /** Counts, and takes the time over so many seconds of world time, or until told to stop. */
    public static StageCost measure(Workload workload, double seconds, BooleanSupplier stop) {
        CountedStages stages = new CountedStages();
        World counted = workload.world().stepper(stages.count(SnapshotStepper.standard())).build();
        for (int k = 0; k < ADVANCEMENTS; k++) {
            counted.advanceTimestep();
        }
        return new StageCost(
                workload.bodies(),
                stages.restricter(),
                stages.partitioner(),
                stages.finder(),
                WallTime.of(
                        workload.world().stepper(SnapshotStepper.standard()).build(),
                        seconds,
                        stop));
    }
}
