package org.auvsim.diagnosis.result;

import java.util.List;

/**
 * What the data can tell apart.
 *
 * @param pairs causes whose traces in the data are nearly the same
 * @param unseen causes that leave no trace in this data, however strong they are
 */
public record Identifiability(List<Confusion> pairs, List<String> unseen) {
    /** Two causes and the angle (degrees) between their traces: 90 apart, 0 the same. */
    public record Confusion(String first, String second, double angle) {}

    /** The lists cannot be changed. */
    public Identifiability {
        pairs = List.copyOf(pairs);
        unseen = List.copyOf(unseen);
    }
}
