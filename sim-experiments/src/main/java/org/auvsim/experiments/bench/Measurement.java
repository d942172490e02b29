package org.auvsim.experiments.bench;

import org.auvsim.core.step.StepStatistics;
import org.auvsim.experiments.workload.Workload;

import java.util.List;

/**
 * What was measured of one workload.
 *
 * @param seconds of world time
 * @param wallSeconds of each repetition, ascending
 * @param statistics of what the steps of a run did
 * @param peakBytes of heap
 * @param energyDrift growth of the energy of a body (percent)
 * @param largestOverlap of two spheres (radii)
 */
public record Measurement(
        Workload workload,
        double seconds,
        List<Double> wallSeconds,
        StepStatistics statistics,
        long peakBytes,
        double energyDrift,
        double largestOverlap) {
    /** Number of bodies. */
    public int bodies() {
        return workload.bodies();
    }

    /** Wall time (s) of the quickest repetition. */
    public double best() {
        return wallSeconds.getFirst();
    }

    /**
     * Wall time (s) of the repetition in the middle; of the slower one of the two in the middle.
     */
    public double median() {
        return wallSeconds.get(wallSeconds.size() / 2);
    }

    /** World seconds a second, in the quickest repetition. */
    public double timesRealTime() {
        return seconds / best();
    }

    /** Bodies moved over one time step of 0.05 s, a second, in the quickest repetition. */
    public double bodyStepsPerSecond() {
        return bodies() * (seconds / Workload.TIME_STEP) / best();
    }

    /** Time (ns) to move a body over one time step of 0.05 s, in the quickest repetition. */
    public double nanosPerBodyStep() {
        return 1e9 / bodyStepsPerSecond();
    }
}
