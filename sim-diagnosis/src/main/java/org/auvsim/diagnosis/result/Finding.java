package org.auvsim.diagnosis.result;

import org.auvsim.diagnosis.cause.Quantity;

import java.util.List;
import java.util.Optional;

/**
 * A cause that was found.
 *
 * @param cause its id
 * @param subject the part of the body that it is about
 * @param quantities its numbers
 * @param deviations the standard deviation of each, in the same order, NaN of what leaves no trace;
 *     empty if none can be stated
 * @param share of all misfit beyond noise that goes when this cause is added last, 0 to 1; several
 *     causes' need not add up to 1
 * @param isOfModel whether it changes the model; not what sensors tell of it, which no scenario has
 */
public record Finding(
        String cause,
        Optional<String> subject,
        List<Quantity> quantities,
        List<Double> deviations,
        double share,
        boolean isOfModel) {
    /** The lists cannot be changed. */
    public Finding {
        quantities = List.copyOf(quantities);
        deviations = List.copyOf(deviations);
    }

    /** The id and what it is about: {@code thruster_gain (port)}. */
    public String name() {
        return subject.map(of -> cause + " (" + of + ")").orElse(cause);
    }
}
