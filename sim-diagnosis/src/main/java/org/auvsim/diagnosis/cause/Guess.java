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
 * @param isBeyond whether the search begins no nearer than a step, as nothing happens before
 */
public record Guess(
        List<Double> theta, List<Integer> columns, List<Double> steps, boolean isBeyond) {
    /** The lists cannot be changed. */
    public Guess {
        theta = List.copyOf(theta);
        columns = List.copyOf(columns);
        steps = List.copyOf(steps);
    }

    /** One from which the search begins where the columns say. */
    public Guess(List<Double> theta, List<Integer> columns, List<Double> steps) {
        this(theta, columns, steps, false);
    }

    /** How far a number of a column is moved that this factor was found for. */
    public double moved(int column, double factor) {
        double step = steps.get(column);
        return isBeyond ? Math.copySign(Math.max(Math.abs(factor), Math.abs(step)), step) : factor;
    }
}
