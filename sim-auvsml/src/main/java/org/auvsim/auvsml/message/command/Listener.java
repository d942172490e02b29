package org.auvsim.auvsml.message.command;

import org.auvsim.core.description.Unit;

import java.util.OptionalDouble;

/**
 * One kind of event that a client wants to hear.
 *
 * @param type an event's name (see {@link EventType}), or {@code *ALL*}
 * @param maxRate at most so many movements a second of world time
 */
public record Listener(String type, @Unit("Hz") OptionalDouble maxRate) {
    /** Stands for every type of event. */
    public static final String ALL = "*ALL*";

    /**
     * A checked request.
     *
     * @throws IllegalArgumentException if the rate is not positive
     */
    public Listener {
        if (maxRate.isPresent() && !(maxRate.getAsDouble() > 0)) {
            throw new IllegalArgumentException(
                    "max-rate must be above 0 Hz, but is " + maxRate.getAsDouble());
        }
    }

    /** Every movement, collision or other event of this type, as often as it comes. */
    public static Listener to(String type) {
        return new Listener(type, OptionalDouble.empty());
    }
}
