package org.auvsim.diagnosis.cause;

import java.util.ArrayList;
import java.util.List;

/**
 * A number of a cause as it is told to people.
 *
 * @param name as {@code k} or {@code u.x}
 * @param unit 1 for a pure number
 */
public record Quantity(String name, String unit, double value) {
    /** The name of the angular frequency (rad/s) of what swings. */
    static final String FREQUENCY = "omega";

    /** The angular frequency (rad/s) of what swings. */
    static Quantity frequency(double omega) {
        return new Quantity(FREQUENCY, "rad/s", omega);
    }

    /** Whether it is the angular frequency of what swings. */
    public boolean isFrequency() {
        return name.equals(FREQUENCY);
    }

    /** Parameters as they are. */
    static List<Quantity> of(List<Parameter> parameters, double[] theta) {
        List<Quantity> quantities = new ArrayList<>();
        for (int i = 0; i < theta.length; i++) {
            Parameter parameter = parameters.get(i);
            quantities.add(new Quantity(parameter.name(), parameter.unit(), theta[i]));
        }
        return quantities;
    }
}
