package org.auvsim.bench;

import org.auvsim.core.step.SnapshotStepper;
import org.auvsim.core.world.World;
import org.auvsim.core.world.WorldEvent;
import org.openjdk.jmh.annotations.AuxCounters;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.BenchmarkMode;
import org.openjdk.jmh.annotations.Fork;
import org.openjdk.jmh.annotations.Level;
import org.openjdk.jmh.annotations.Measurement;
import org.openjdk.jmh.annotations.Mode;
import org.openjdk.jmh.annotations.Param;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;
import org.openjdk.jmh.annotations.Warmup;

/**
 * The thesis' section 8.2: how many seconds of world time a second of the machine's buys, over the
 * 120 s of the {@link Workload}, with the thesis' own stages.
 */
@State(Scope.Thread)
@BenchmarkMode(Mode.SingleShotTime)
@Warmup(iterations = 5)
@Measurement(iterations = 5)
@Fork(1)
public class WorkloadBenchmark {
    private static final double WORLD_SECONDS = 120;

    /** Number of bodies. */
    @Param({"10", "50", "100"})
    public int bodies;

    private World world = World.builder().build();

    /** What happened in a run, printed beside its time. */
    @State(Scope.Thread)
    @AuxCounters(AuxCounters.Type.EVENTS)
    public static class Counts {
        public long collisions;
        public long snapshots;
        public double timesRealTime;

        private long begin;

        /** Forgets the last run. */
        @Setup(Level.Iteration)
        public void forget() {
            collisions = 0;
            snapshots = 0;
            begin = System.nanoTime();
        }

        void count(WorldEvent event) {
            if (event instanceof WorldEvent.Collided) {
                collisions++;
            } else if (event instanceof WorldEvent.StepAdvanced) {
                snapshots++;
            }
        }
    }

    /** Builds the world anew. */
    @Setup(Level.Iteration)
    public void build() {
        world = new Workload(bodies, 1).world(SnapshotStepper.standard());
    }

    /** Runs it. */
    @Benchmark
    public long run(Counts counts) {
        world.addListener(counts::count);
        counts.begin = System.nanoTime();
        while (world.time() < WORLD_SECONDS) {
            world.advanceTimestep();
        }
        counts.timesRealTime = WORLD_SECONDS * 1e9 / (System.nanoTime() - counts.begin);
        return world.stateHash();
    }
}
