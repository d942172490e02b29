package org.auvsim.examples.stage;

import org.auvsim.core.step.CollisionPartitioner;
import org.auvsim.core.step.PartitionerContract;

/** A stage of a user's own is tested by sim-core's contract for it. */
class SweepPartitionerTest extends PartitionerContract {
    @Override
    protected CollisionPartitioner partitioner() {
        return new SweepPartitioner();
    }
}
