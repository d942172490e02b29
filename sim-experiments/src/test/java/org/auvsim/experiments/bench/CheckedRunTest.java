package org.auvsim.experiments.bench;

import static org.assertj.core.api.Assertions.assertThat;

import org.auvsim.core.step.AllPairsPartitioner;
import org.auvsim.core.step.EndOfStepFinder;
import org.auvsim.core.step.NoRestricter;
import org.auvsim.core.step.SnapshotStepper;
import org.auvsim.core.world.World;
import org.auvsim.experiments.workload.Workload;
import org.junit.jupiter.api.Test;

class CheckedRunTest {
    private static final Workload WORKLOAD = Workload.of(20);

    private static CheckedRun run(SnapshotStepper stepper) {
        World world = WORKLOAD.world().stepper(stepper).build();
        CheckedRun run = new CheckedRun(WORKLOAD, world);
        run.run(5, () -> false);
        return run;
    }

    /** What looks once a step lets spheres sink into each other. */
    @Test
    void seesTheOverlapOfAFinderThatAllowsIt() {
        CheckedRun run =
                run(
                        new SnapshotStepper(
                                new NoRestricter(),
                                new AllPairsPartitioner(),
                                new EndOfStepFinder()));

        assertThat(run.largestOverlap()).isGreaterThan(0.05);
    }

    @Test
    void theThesisStagesLetSpheresOverlapByLittle() {
        CheckedRun run = run(SnapshotStepper.standard());

        assertThat(run.statistics().collisions()).isPositive();
        assertThat(run.largestOverlap()).isLessThan(0.02);
        assertThat(run.energyDrift()).isBetween(-2.0, 2.0);
    }

    @Test
    void stopsWhenTold() {
        World world = WORKLOAD.world().build();
        new CheckedRun(WORKLOAD, world).run(100, () -> world.time() > 0.2);

        assertThat(world.time()).isLessThan(0.5);
    }
}
