package org.auvsim.diagnosis.verdict;

import org.auvsim.diagnosis.result.Diagnosis;
import org.auvsim.diagnosis.result.Proposal;

import java.util.Optional;

/** Looks for what imitates a misfit that no known cause explains. */
@FunctionalInterface
public interface Imitator {
    /**
     * What imitates it, also on held-out runs; empty if nothing does, or once it was told to stop.
     *
     * @param unexplained what is known of the misfit
     * @param trial says how well something imitates it, and whether to go on
     */
    Optional<Proposal> proposal(Diagnosis unexplained, ImitationTrial trial);
}
