package org.auvsim.experiments.bench;

import org.auvsim.core.entity.Contact;
import org.auvsim.core.entity.Participant;
import org.auvsim.core.math.Vec3;
import org.auvsim.core.step.StepStatistics;
import org.auvsim.core.world.World;
import org.auvsim.core.world.WorldEvent;
import org.auvsim.experiments.workload.Workload;

import java.util.function.BooleanSupplier;

/**
 * A run that is not timed, to see whether what was timed was right: the largest overlap of two
 * spheres, the energy, and what happened. Overlap is looked for at the end of each step, at
 * instants within it, and between the two of each collision where they collide.
 */
final class CheckedRun {
    /** Instants a step at which all pairs are looked at, its end included. */
    private static final int INSTANTS = 4;

    private final Workload workload;
    private final World world;
    private final StepPaths paths;
    private final OverlapCheck check;
    private final double[] centres;
    private final double energyBefore;
    private double largestOverlap;

    /** Of a world of this workload that has not begun. */
    CheckedRun(Workload workload, World world) {
        this.workload = workload;
        this.world = world;
        paths = new StepPaths(world);
        check = new OverlapCheck(workload.bodies(), Workload.RADIUS);
        centres = new double[3 * workload.bodies()];
        energyBefore = workload.energy(world);
        world.addListener(this::hear);
    }

    /** Runs to a world time (s), or until told to stop. */
    void run(double until, BooleanSupplier stop) {
        while (!Clock.isOver(world, until) && !stop.getAsBoolean()) {
            world.advanceTimestep();
            paths.stepped();
            lookForOverlap();
            paths.forget();
        }
    }

    private void lookForOverlap() {
        for (int k = 1; paths.length() > 0 && k <= INSTANTS; k++) {
            paths.write((double) k / INSTANTS, centres);
            largestOverlap = Math.max(largestOverlap, check.largest(centres));
        }
    }

    private void hear(WorldEvent event) {
        if (event instanceof WorldEvent.Collided collided) {
            Contact contact = collided.collision().contact();
            double distance = place(contact.self()).distance(place(contact.other()));
            double overlap = OverlapCheck.ofDistance(distance, Workload.RADIUS);
            largestOverlap = Math.max(largestOverlap, overlap);
        }
    }

    private static Vec3 place(Participant participant) {
        return participant.body().orElseThrow().state().position();
    }

    /** The largest overlap seen, in radii. */
    double largestOverlap() {
        return largestOverlap;
    }

    /** By how much the energy of a body has grown on average, in percent of what it was. */
    double energyDrift() {
        return 100 * (workload.energy(world) / energyBefore - 1);
    }

    /** What its steps have done. */
    StepStatistics statistics() {
        return world.statistics();
    }

    /** The world's digest, which must be that of the timed run. */
    long stateHash() {
        return world.stateHash();
    }
}
