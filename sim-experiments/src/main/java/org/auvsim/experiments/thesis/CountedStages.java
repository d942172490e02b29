package org.auvsim.experiments.thesis;

import org.auvsim.core.step.CollisionFinder;
import org.auvsim.core.step.CollisionPartitioner;
import org.auvsim.core.step.CollisionSets;
import org.auvsim.core.step.Motion;
import org.auvsim.core.step.SnapshotStepper;
import org.auvsim.core.step.TimeStepRestricter;

/**
 * The three stages of a {@link SnapshotStepper}, each with a count of the primitive operations that
 * were done in it; for one world.
 */
final class CountedStages {
    private long restricter;
    private long partitioner;
    private long finder;

    /** The stepper with its stages counted here; it does the same. */
    SnapshotStepper count(SnapshotStepper stepper) {
        return new SnapshotStepper(
                restricter(stepper.restricter()),
                partitioner(stepper.partitioner()),
                finder(stepper.finder()));
    }

    private TimeStepRestricter restricter(TimeStepRestricter stage) {
        return (Motion motion, double wanted) -> {
            long before = motion.operations();
            double dt = stage.restrict(motion, wanted);
            restricter += motion.operations() - before;
            return dt;
        };
    }

    private CollisionPartitioner partitioner(CollisionPartitioner stage) {
        return (Motion motion, double dt, CollisionSets sets) -> {
            long before = motion.operations();
            stage.partition(motion, dt, sets);
            partitioner += motion.operations() - before;
        };
    }

    private CollisionFinder finder(CollisionFinder stage) {
        return (Motion motion, CollisionSets sets, double dt) -> {
            long before = motion.operations();
            double earliest = stage.earliest(motion, sets, dt);
            finder += motion.operations() - before;
            return earliest;
        };
    }

    /** Operations of the first stage. */
    long restricter() {
        return restricter;
    }

    /** Operations of the second stage. */
    long partitioner() {
        return partitioner;
    }

    /** Operations of the third stage. */
    long finder() {
        return finder;
    }
}
