package org.auvsim.bench.peers;

import org.auvsim.experiments.bench.OverlapCheck;
import org.auvsim.experiments.workload.Workload;

/**
 * A run of a peer: the same forces as ours, but looked up once a step; overlap and energy are
 * looked at outside of the time that is taken.
 */
final class PeerRun {
    private final Workload workload;
    private final PeerWorld world;
    private final double[] targets;
    private final double[] places;
    private final double[] velocities;
    private final double[] forces;
    private final OverlapCheck check;
    private double wallSeconds;
    private double largestOverlap;
    private long steps;

    /** Of a world that holds this workload. */
    PeerRun(Workload workload, PeerWorld world) {
        this.workload = workload;
        this.world = world;
        targets = workload.targetPoints();
        places = workload.positions();
        velocities = new double[places.length];
        forces = new double[places.length];
        check = new OverlapCheck(workload.bodies(), Workload.RADIUS);
    }

    /** Runs over so many seconds of world time, but for no more than {@code patience} (s). */
    void run(double seconds, double patience) {
        long wanted = Math.round(seconds / Workload.TIME_STEP);
        for (steps = 0; steps < wanted && wallSeconds < patience; steps++) {
            long begin = System.nanoTime();
            world.positions(places);
            drive();
            world.step(forces, Workload.TIME_STEP);
            wallSeconds += (System.nanoTime() - begin) * 1e-9;
            world.positions(places);
            largestOverlap = Math.max(largestOverlap, check.largest(places));
        }
    }

    private void drive() {
        for (int at = 0; at < places.length; at += 3) {
            double x = targets[at] - places[at];
            double y = targets[at + 1] - places[at + 1];
            double z = targets[at + 2] - places[at + 2];
            double distance = Math.sqrt(x * x + y * y + z * z);
            double scale = distance > Workload.REST_RADIUS ? Workload.FORCE / distance : 0;
            forces[at] = x * scale;
            forces[at + 1] = y * scale;
            forces[at + 2] = z * scale;
        }
    }

    /** World time (s) that the run has come to. */
    double seconds() {
        return steps * Workload.TIME_STEP;
    }

    /** World seconds a second. */
    double timesRealTime() {
        return seconds() / wallSeconds;
    }

    /** The largest overlap after a step (radii). */
    double largestOverlap() {
        return largestOverlap;
    }

    /** Kinetic and potential energy of a body (J), on average. */
    double energy() {
        world.positions(places);
        world.velocities(velocities);
        double sum = 0;
        for (int at = 0; at < places.length; at += 3) {
            double distance = 0;
            double speed = 0;
            for (int k = at; k < at + 3; k++) {
                distance += (places[k] - targets[k]) * (places[k] - targets[k]);
                speed += velocities[k] * velocities[k];
            }
            sum += Workload.MASS * speed / 2;
            sum += Workload.FORCE * Math.max(Math.sqrt(distance), Workload.REST_RADIUS);
        }
        return sum / workload.bodies();
    }
}
