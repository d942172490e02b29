package org.auvsim.diagnosis.result;

import org.auvsim.auvsml.document.Scenario;

import java.util.List;

/**
 * A model that is not right but much nearer to the runs than the one that was believed. Its causes
 * stand for something that is not known, and may be quite other ones: they are no findings.
 *
 * @param causes the best that were tried, without deviations
 * @param scenario the model with them
 */
public record Approximation(List<Finding> causes, Scenario scenario) {
    /** The list cannot be changed. */
    public Approximation {
        causes = List.copyOf(causes);
    }
}
