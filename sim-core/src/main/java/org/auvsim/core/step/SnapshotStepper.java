package org.auvsim.core.step;

import org.auvsim.core.description.Default;

import java.util.ArrayList;
import java.util.List;

/**
 * The thesis' step (section 5.1): one snapshot a step, which ends at the earliest collision or
 * after the restricted time step.
 */
public record SnapshotStepper(
        @Default("radius-distance-restricter") TimeStepRestricter restricter,
        @Default("octree-partitioner") CollisionPartitioner partitioner,
        @Default("bisection-finder") CollisionFinder finder)
        implements Stepper {
    /** With the thesis' stages: radius-distance restricter, octree, bisection. */
    public static SnapshotStepper standard() {
        return new SnapshotStepper(
                new RadiusDistanceRestricter(),
                OctreePartitioner.standard(),
                BisectionFinder.standard());
    }

    @Override
    public StepResult advance(Motion motion, double wanted) {
        double dt = restricter.restrict(motion, wanted);
        CollisionSets sets = motion.sets();
        sets.begin(dt);
        partitioner.partition(motion, dt, sets);
        sets.close();
        double collision = finder.earliest(motion, sets, dt);
        if (collision <= dt) {
            return collide(motion, sets, collision);
        }
        motion.commit(dt);
        return StepResult.of(dt, List.of());
    }

    private static List<Pair> touching(Motion motion, CollisionSets sets) {
        List<Pair> touching = new ArrayList<>();
        for (int k = 0; k < sets.pairCount(); k++) {
            int i = sets.first(k);
            int j = sets.second(k);
            if (motion.overlap(i, j, 0) && motion.approaching(i, j, 0)) {
                touching.add(new Pair(i, j));
            }
        }
        return touching;
    }

    /** To the instant of a collision, and through it; all of it or nothing. */
    private static StepResult collide(Motion motion, CollisionSets sets, double elapsed) {
        motion.keep();
        try {
            motion.commit(elapsed);
            StepResult result = Responses.to(motion, touching(motion, sets), elapsed);
            motion.tally().events++;
            motion.tally().collisions += result.collisions().size();
            return result;
        } catch (RuntimeException e) {
            motion.goBack();
            throw e;
        }
    }
}
