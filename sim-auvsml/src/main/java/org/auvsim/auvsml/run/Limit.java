package org.auvsim.auvsml.run;

import java.util.Optional;

/**
 * Up to where a column's numbers are of use: with the first one beyond, the run ends before it. A
 * vehicle that touches the floor does what no model of its swimming has.
 *
 * @param above larger numbers are beyond; in the usual unit of the column
 * @param below smaller ones are
 */
public record Limit(Optional<Double> above, Optional<Double> below) {
    /**
     * A checked limit.
     *
     * @throws IllegalArgumentException if nothing or everything is beyond
     */
    public Limit {
        if (above.isEmpty() && below.isEmpty()) {
            throw new IllegalArgumentException(
                    "a run ends where a number is above or below a limit, but none is given");
        }
        if (above.isPresent() && below.isPresent() && !(below.get() < above.get())) {
            throw new IllegalArgumentException(
                    "a run ends where a number is above %s or below %s: that is always so; give a smaller 'below'"
                            .formatted(above.get(), below.get()));
        }
    }

    /** Whether a number is beyond. */
    public boolean isPassedBy(double number) {
        return above.filter(most -> number > most).isPresent()
                || below.filter(least -> number < least).isPresent();
    }
}
