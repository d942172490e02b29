package org.auvsim.experiments.thesis;

import static org.assertj.core.api.Assertions.assertThat;

import org.auvsim.core.step.AllPairsPartitioner;
import org.auvsim.core.step.NoRestricter;
import org.auvsim.core.step.SnapshotStepper;
import org.auvsim.core.world.World;
import org.auvsim.experiments.workload.Workload;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class CountedStagesTest {
    private static final SnapshotStepper STANDARD = SnapshotStepper.standard();

    private final CountedStages stages = new CountedStages();

    private static World run(SnapshotStepper stepper, int bodies, int steps) {
        World world = Workload.of(bodies).world().stepper(stepper).build();
        for (int k = 0; k < steps; k++) {
            world.advanceTimestep();
        }
        return world;
    }

    @Test
    void countingChangesNothing() {
        World counted = run(stages.count(STANDARD), 20, 100);

        assertThat(counted.stateHash()).isEqualTo(run(STANDARD, 20, 100).stateHash());
        assertThat(counted.statistics().collisions()).isPositive();
        assertThat(stages.finder()).isPositive();
    }

    /** At rest and far apart each body is asked once how far it moves, and no pair is looked at. */
    @ParameterizedTest
    @ValueSource(ints = {10, 40, 100})
    void theFirstStepAsksEachBodyOnce(int bodies) {
        run(stages.count(STANDARD), bodies, 1);
        long one = stages.restricter() / bodies;

        assertThat(one).isPositive();
        assertThat(stages.restricter()).isEqualTo(bodies * one);
        assertThat(stages.partitioner()).isGreaterThan(bodies);
        assertThat(stages.finder()).isZero();
    }

    @Test
    void eachStageIsCountedForItself() {
        SnapshotStepper simple =
                new SnapshotStepper(
                        new NoRestricter(), new AllPairsPartitioner(), STANDARD.finder());

        run(stages.count(simple), 20, 60);

        assertThat(stages.restricter()).isZero();
        assertThat(stages.partitioner()).isZero();
        assertThat(stages.finder()).isPositive();
    }
}
