package org.auvsim.experiments.hidden;

/** What pushes a body, by how it moves now. */
@FunctionalInterface
interface Force {
    Wrench on(Instant at);
}
