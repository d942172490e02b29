package org.auvsim.auvsml.document;

import org.auvsim.core.description.Unit;

/** By how much a step moves time on if nothing shortens it. */
public record TimeStep(@Unit("s") double delta) {
    /**
     * A checked time step.
     *
     * @throws IllegalArgumentException if it is not above 0
     */
    public TimeStep {
        if (!(delta > 0)) {
            throw new IllegalArgumentException(
                    "the time step must be above 0 s, but is " + delta + " s");
        }
    }
}
