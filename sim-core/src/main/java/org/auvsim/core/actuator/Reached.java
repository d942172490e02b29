package org.auvsim.core.actuator;

import org.auvsim.core.description.Unit;
import org.auvsim.core.entity.Domain;

/**
 * How far an actuator had come when it last heard a command: from there it goes on towards what it
 * was told, as a function of time.
 *
 * @param value level of a propulsor, or angle (rad) of a fin
 * @param at world time (s) of that
 */
public record Reached(double value, @Unit("s") double at) {
    /**
     * A checked state.
     *
     * @throws IllegalArgumentException if a number is not finite
     */
    public Reached {
        Domain.finite("what an actuator has reached", "value", value, "");
        Domain.finite("what an actuator has reached", "time", at, "s");
    }
}
