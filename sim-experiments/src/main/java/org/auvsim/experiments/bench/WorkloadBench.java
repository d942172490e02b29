package org.auvsim.experiments.bench;

import org.auvsim.core.step.Lanes;
import org.auvsim.core.world.World;
import org.auvsim.experiments.workload.Workload;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Optional;
import java.util.function.BooleanSupplier;

/**
 * Measures how fast worlds of a workload go on: some timed runs, one after the other, and one that
 * is checked and not timed.
 *
 * @param stepper how steps are made
 * @param lanes on which they are made
 * @param warmUp wall time (s) of untimed runs before, in which the machine code gets ready
 * @param repetitions timed runs, 1 or more
 */
public record WorkloadBench(StepperChoice stepper, Lanes lanes, double warmUp, int repetitions) {
    /**
     * With checked numbers.
     *
     * @throws IllegalArgumentException if there are no repetitions
     */
    public WorkloadBench {
        if (repetitions < 1) {
            throw new IllegalArgumentException(
                    "a bench needs 1 or more repetitions, but has " + repetitions);
        }
    }

    /**
     * Measures over so many seconds of world time; nothing if told to stop.
     *
     * @throws IllegalStateException if equal worlds have not stayed equal
     */
    public Optional<Measurement> measure(Workload workload, double seconds, BooleanSupplier stop) {
        warmUp(workload, seconds, stop);
        List<Double> wall = new ArrayList<>();
        PeakMemory memory = new PeakMemory();
        long peak = 0;
        long hash = 0;
        for (int k = 0; k < repetitions && !stop.getAsBoolean(); k++) {
            World world = world(workload);
            memory.reset();
            wall.add(time(world, seconds, stop));
            peak = Math.max(peak, memory.bytes());
            hash = world.stateHash();
        }
        CheckedRun check = new CheckedRun(workload, world(workload));
        check.run(seconds, stop);
        if (stop.getAsBoolean()) {
            return Optional.empty();
        }
        requireSame(hash, check.stateHash());
        Collections.sort(wall);
        return Optional.of(
                new Measurement(
                        workload,
                        seconds,
                        List.copyOf(wall),
                        check.statistics(),
                        peak,
                        check.energyDrift(),
                        check.largestOverlap()));
    }

    private World world(Workload workload) {
        return workload.world().stepper(stepper.stepper()).lanes(lanes).build();
    }

    private void warmUp(Workload workload, double seconds, BooleanSupplier stop) {
        long end = System.nanoTime() + (long) (warmUp * 1e9);
        while (System.nanoTime() < end && !stop.getAsBoolean()) {
            time(world(workload), seconds, () -> stop.getAsBoolean() || System.nanoTime() > end);
        }
    }

    /** Wall time (s) of a run. */
    private static double time(World world, double until, BooleanSupplier stop) {
        long begin = System.nanoTime();
        while (!Clock.isOver(world, until) && !stop.getAsBoolean()) {
            world.advanceTimestep();
        }
        return (System.nanoTime() - begin) * 1e-9;
    }

    private static void requireSame(long timed, long checked) {
        if (timed != checked) {
            throw new IllegalStateException(
                    "two runs of the same world differ: their states' hashes are %016x and %016x"
                            .formatted(timed, checked));
        }
    }
}
