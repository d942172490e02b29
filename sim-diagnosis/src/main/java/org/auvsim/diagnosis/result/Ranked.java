package org.auvsim.diagnosis.result;

import org.auvsim.diagnosis.cause.Quantity;

import java.util.List;
import java.util.Optional;

/**
 * A set of causes that was tried; the empty one is the model as it is believed.
 *
 * @param causes names as {@link Finding#name}
 * @param quantities the numbers of each cause, NaN of what the data does not determine
 * @param logEvidence natural logarithm, up to the same constant for all sets
 * @param probability among all sets that were tried
 * @param behind why it was not chosen, where its evidence is larger than that of what was; where
 *     nothing was, why errors and residuals are not told of it. The first without it is the one
 *     that they are told of
 */
public record Ranked(
        List<String> causes,
        List<List<Quantity>> quantities,
        double logEvidence,
        double probability,
        Optional<String> behind) {
    /** The lists cannot be changed. */
    public Ranked {
        causes = List.copyOf(causes);
        quantities = List.copyOf(quantities);
    }

    /** The causes in a row. */
    public String name() {
        return causes.isEmpty() ? "none" : String.join(" + ", causes);
    }
}
