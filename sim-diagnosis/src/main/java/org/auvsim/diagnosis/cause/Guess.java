package org.auvsim.diagnosis.cause;

import java.util.List;

/**
 * Where the search for a cause begins: numbers with which it does nothing yet, as a vortex of no
 * strength at a place. What the data says of it is first judged by columns: how the motion changes
 * when one number does.
 *
 * @param theta a number for each parameter of the cause, those of {@code columns} 0
 * @param columns which of them are moved
 * @param steps by how much each of those is moved; a large step gives the secant of an effect that
 *     is not smooth
 */
public record Guess(List<Double> theta, List<Integer> columns, List<Double> steps) {
    /** The lists cannot be changed. */
    public Guess {
        theta = List.copyOf(theta);
        columns = List.copyOf(columns);
        steps = List.copyOf(steps);
    }
}
