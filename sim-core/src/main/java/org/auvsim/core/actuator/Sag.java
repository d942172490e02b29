package org.auvsim.core.actuator;

import org.auvsim.core.description.Default;
import org.auvsim.core.description.Unit;
import org.auvsim.core.entity.Domain;

/**
 * A propulsor's thrust that falls evenly, as the voltage of a battery that empties, until nothing
 * is left.
 *
 * @param from when it begins (s, the world's time)
 * @param fade share of its thrust that is lost in each second (1/s); below 0 it grows
 */
public record Sag(@Unit("s") @Default("0.0") double from, @Unit("1/s") double fade) {
    /**
     * A checked sag.
     *
     * @throws IllegalArgumentException naming the number that is not finite
     */
    public Sag {
        Domain.finite("the sag of a propulsor", "time", from, "s");
        Domain.finite("the sag of a propulsor", "fade", fade, "1/s");
    }

    /** The share of the thrust that is left at a time (s). */
    double leftAt(double time) {
        return Math.max(0, 1 - fade * Math.max(0, time - from));
    }
}
