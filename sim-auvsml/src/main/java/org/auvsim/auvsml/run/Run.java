package org.auvsim.auvsml.run;

import java.util.List;
import java.util.Optional;

/**
 * What is known of a measured run beside its rows: the root element of the file beside them. All in
 * the world's axes, whatever those of the rows.
 *
 * @param role what it is there for; empty: as the command says
 * @param start how the body moved at the first row, as far as it is known otherwise
 * @param scheduledForce what pushed the body for a while
 * @param differences what this run had that the scenario has not
 */
public record Run(
        Optional<RunRole> role,
        Optional<RunStart> start,
        List<TimedPush> scheduledForce,
        Optional<RunDifferences> differences) {
    /** Nothing is known. */
    public static final Run NOTHING_KNOWN =
            new Run(Optional.empty(), Optional.empty(), List.of(), Optional.empty());

    /** The list cannot be changed. */
    public Run {
        scheduledForce = List.copyOf(scheduledForce);
    }
}
