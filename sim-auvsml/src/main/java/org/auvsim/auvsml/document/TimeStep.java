package org.auvsim.auvsml.document;

import org.auvsim.core.description.Unit;

/** By how much a step moves time on if nothing shortens it. */
public record TimeStep(@Unit("s") double delta) {
    /** Shorter ones (s) get nowhere, and in time do not change it at all. */
    private static final double LEAST = 1e-9;

    /**
     * A checked time step.
     *
     * @throws IllegalArgumentException if it is below 1e-9 s
     */
    public TimeStep {
        if (!(delta >= LEAST)) {
            throw new IllegalArgumentException(
                    "the time step must be " + LEAST + " s or more, but is " + delta + " s");
        }
    }
}
