package org.auvsim.diagnosis.result;

import java.util.List;

/**
 * What the data can tell apart.
 *
 * @param pairs causes whose traces in the data are nearly the same
 * @param unseen causes that leave no trace in this data unless they are very strong
 * @param unobservable causes that change nothing of what was measured: what they do is held by a
 *     mount, was not measured, or does not come about
 * @param smallest what would hardly have been missed of the others
 */
public record Identifiability(
        List<Confusion> pairs,
        List<String> unseen,
        List<String> unobservable,
        List<Smallest> smallest) {
    /**
     * Two causes and the angle (degrees) between their traces: 90 apart, 0 the same.
     *
     * @param first a cause
     * @param firstNumber its number that is most like the other cause
     * @param second the other cause
     * @param secondNumber its number that is most like the first
     */
    public record Confusion(
            String first, String firstNumber, String second, String secondNumber, double angle) {}

    /**
     * How large a number of a cause must be to be found in this data, to first order; of what acts
     * from a place, or from a time on, at the one where it shows best of those that were looked at.
     *
     * @param cause its name
     * @param parameter the number's name
     * @param unit of the size
     * @param size a change that would be found in 97 of 100 such measurements
     */
    public record Smallest(String cause, String parameter, String unit, double size) {}

    /** The lists cannot be changed. */
    public Identifiability {
        pairs = List.copyOf(pairs);
        unseen = List.copyOf(unseen);
        unobservable = List.copyOf(unobservable);
        smallest = List.copyOf(smallest);
    }
}
