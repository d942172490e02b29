package org.auvsim.cli;

import org.auvsim.core.step.StepException;
import org.auvsim.core.step.StepStatistics;
import org.auvsim.core.world.World;
import org.auvsim.core.world.WorldEvent;
import org.auvsim.core.world.WorldException;

import java.util.Locale;
import java.util.function.BooleanSupplier;
import java.util.function.Consumer;

/** A world that runs on its own, as fast as it can. */
final class BatchRun {
    /** Sums of time steps round: so close (s) to its end a run is over. */
    private static final double TOLERANCE = 1e-9;

    private final World world;
    private final Consumer<World> afterStep;
    private final long began = System.nanoTime();
    private final double startTime;
    private long steps;
    private long collisions;

    /** A run of {@code world}; {@code afterStep} sees the world after each step. */
    BatchRun(World world, Consumer<World> afterStep) {
        this.world = world;
        this.afterStep = afterStep;
        this.startTime = world.time();
        world.addListener(
                event -> {
                    if (event instanceof WorldEvent.Collided) {
                        collisions++;
                    }
                });
    }

    /**
     * Runs to world time {@code until} (s), or until {@code interrupted}.
     *
     * @throws RunEndedException if a step cannot be made
     */
    void run(double until, BooleanSupplier interrupted) {
        while (world.time() < until - TOLERANCE && !interrupted.getAsBoolean()) {
            try {
                world.advanceTimestep();
            } catch (StepException | WorldException e) {
                throw new RunEndedException(
                        "The run ends at %s s: %s".formatted(world.time(), e.getMessage()), e);
            }
            steps++;
            afterStep.accept(world);
        }
    }

    /** Wall-clock time (s) since the beginning. */
    double elapsed() {
        return (System.nanoTime() - began) * 1e-9;
    }

    /** World seconds a second so far. */
    double timesRealTime() {
        return (world.time() - startTime) / elapsed();
    }

    /** What has been done, in a line. */
    String summary() {
        StepStatistics done = world.statistics();
        return String.format(
                Locale.ROOT,
                "%d steps: %.6g s of world time in %.3g s, %.3g times real time; %d collisions,"
                        + " %d events, %d sub-steps, %d contacts held, %d quick hits,"
                        + " %d crowded hits, %d lowered hits, %d islands unsolved",
                steps,
                world.time() - startTime,
                elapsed(),
                timesRealTime(),
                collisions,
                done.events(),
                done.subSteps(),
                done.heldPairs(),
                done.quickHits(),
                done.crowdedHits(),
                done.loweredHits(),
                done.unsolvedIslands());
    }
}
