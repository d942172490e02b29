package org.auvsim.diagnosis.result;

import java.util.List;

/**
 * The run that would tell most among the models that are left.
 *
 * @param id from a menu: {@code drop}, {@code spin_up}, {@code coast_down} ...
 * @param description what to do
 * @param separates names of the causes that it would tell apart
 * @param evidence difference in log evidence to be expected
 */
public record NextExperiment(
        String id, String description, List<String> separates, double evidence) {
    /** The list cannot be changed. */
    public NextExperiment {
        separates = List.copyOf(separates);
    }
}
