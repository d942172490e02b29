package org.auvsim.bench;

import org.auvsim.core.world.World;
import org.auvsim.experiments.bench.StepperChoice;
import org.auvsim.experiments.workload.Workload;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.BenchmarkMode;
import org.openjdk.jmh.annotations.Fork;
import org.openjdk.jmh.annotations.Measurement;
import org.openjdk.jmh.annotations.Mode;
import org.openjdk.jmh.annotations.OutputTimeUnit;
import org.openjdk.jmh.annotations.Param;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;
import org.openjdk.jmh.annotations.Warmup;

import java.util.concurrent.TimeUnit;

/**
 * A step of the workload of section 8.2 in its steady state, which it has reached after 20 s of
 * world time. With {@code -prof gc}, what a step allocates: the event stepper, nothing.
 */
@State(Scope.Thread)
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.MICROSECONDS)
@Warmup(iterations = 5, time = 1)
@Measurement(iterations = 5, time = 1)
@Fork(1)
public class StepBenchmark {
    private static final double SETTLED = 20;

    /** Number of bodies. */
    @Param({"100", "1000"})
    public int bodies;

    /** How a step is made. */
    @Param("EVENT")
    public StepperChoice stepper = StepperChoice.EVENT;

    private World world = World.builder().build();

    /** Lets the world come to its steady state. */
    @Setup
    public void settle() {
        world = Workload.of(bodies).world().stepper(stepper.stepper()).build();
        while (world.time() < SETTLED) {
            world.advanceTimestep();
        }
    }

    /** A step of 0.05 s. */
    @Benchmark
    public double step() {
        return world.advanceTimestep();
    }
}
