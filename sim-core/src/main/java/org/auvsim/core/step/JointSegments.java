package org.auvsim.core.step;

/**
 * Segments of bodies that hang together: they begin together and end together, before the frame
 * does where the forces on one of the bodies are stiff.
 */
final class JointSegments {
    private final SegmentIntegrator integrator;
    private final int[] version;

    /**
     * Segments that an integrator traces.
     *
     * @param version counts the segments of each body, by slot
     */
    JointSegments(SegmentIntegrator integrator, int[] version) {
        this.integrator = integrator;
        this.version = version;
    }

    /** As {@link Trajectories#restartTogether}. */
    double restart(int[] slots, int number, double offset, double latest, double[] endVelocities) {
        int notFinite = integrator.notFinite;
        double last = latest;
        int fine = latest < integrator.length() ? SegmentIntegrator.FINE : 1;
        int wanted = trace(slots, number, offset, last, endVelocities);
        for (int parts = wanted; wanted > fine; parts *= 2) {
            fine = SegmentIntegrator.FINE;
            last = offset + (latest - offset) / parts;
            if (integrator.isTooShort(offset, last)) {
                integrator.tooStiff = slots[0];
                return latest;
            }
            // What was too long a segment does not count, whatever it ended with.
            integrator.notFinite = notFinite;
            wanted = trace(slots, number, offset, last, endVelocities);
        }
        return last;
    }

    /** Traces bodies from one offset to another; into how many parts that should be cut. */
    private int trace(int[] slots, int number, double from, double to, double[] endVelocities) {
        int parts = 1;
        for (int first = 0; first < number; first += integrator.loaded()) {
            integrator.load(slots, first, number, from);
            parts = Math.max(parts, integrator.integrateWhole(from, to));
            integrator.writeVelocities(endVelocities, first);
        }
        for (int k = 0; k < number; k++) {
            version[slots[k]]++;
        }
        return parts;
    }

    /** The velocities that bodies have in their present states, as {@link #restart} tells them. */
    void velocitiesNow(int[] slots, int number, double[] to) {
        // No force matters here, and so nobody they couple.
        for (int first = 0; first < number; first += integrator.loaded()) {
            integrator.loadUncoupled(slots, first, number, 0);
            integrator.writeVelocities(to, first);
        }
    }
}
