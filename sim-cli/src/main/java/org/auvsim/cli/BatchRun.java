package org.auvsim.cli;

import org.auvsim.core.step.StepException;
import org.auvsim.core.step.StepStatistics;
import org.auvsim.core.world.World;
import org.auvsim.core.world.WorldEvent;
import org.auvsim.core.world.WorldException;

import java.util.Locale;
import java.util.function.BooleanSupplier;
import java.util.function.Consumer;
import java.util.stream.Collectors;
import java.util.stream.Stream;

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

    /** What has been done, in a line; of what seldom comes about only what did. */
    String summary() {
        StepStatistics done = world.statistics();
        return String.format(
                        Locale.ROOT,
                        "%d steps: %.6g s of world time in %.3g s, %.3g times real time; %s",
                        steps,
                        world.time() - startTime,
                        elapsed(),
                        timesRealTime(),
                        collisions == 0 ? "no collisions" : counted(collisions, "collision"))
                + Stream.of(
                                counted(done.events(), "event"),
                                counted(done.subSteps(), "sub-step"),
                                counted(done.heldPairs(), "contact", " held"),
                                counted(done.quickHits(), "quick hit"),
                                counted(done.crowdedHits(), "crowded hit"),
                                counted(done.loweredHits(), "lowered hit"),
                                counted(done.unsolvedIslands(), "island", " unsolved"))
                        .filter(count -> !count.startsWith("0 "))
                        .map(", "::concat)
                        .collect(Collectors.joining());
    }

    private static String counted(long count, String one) {
        return counted(count, one, "");
    }

    private static String counted(long count, String one, String how) {
        return "%d %s%s%s".formatted(count, one, count == 1 ? "" : "s", how);
    }
}
