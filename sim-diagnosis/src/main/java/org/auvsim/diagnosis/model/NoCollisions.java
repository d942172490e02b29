package org.auvsim.diagnosis.model;

import org.auvsim.core.step.CollisionPartitioner;
import org.auvsim.core.step.CollisionSets;
import org.auvsim.core.step.Motion;

/** Lets everything pass through everything: no sets, no collisions. */
record NoCollisions() implements CollisionPartitioner {
    @Override
    public void partition(Motion motion, double dt, CollisionSets sets) {
        // no sets
    }
}
