package org.auvsim.auvsml.run;

import org.auvsim.core.description.Default;
import org.auvsim.core.description.Unit;
import org.auvsim.core.entity.Frame;
import org.auvsim.core.math.Vec3;

/**
 * A force that acted on the body for a while.
 *
 * @param from when it began, by the rows' clock
 * @param until when it ended
 * @param frame the axes of the vector
 * @param point where it acted, in body coordinates
 */
public record TimedPush(
        String name,
        @Unit("s") double from,
        @Unit("s") double until,
        @Default("WORLD") Frame frame,
        @Unit("N") Vec3 vector,
        @Unit("m") @Default("0 0 0") Vec3 point) {
    /**
     * A checked push.
     *
     * @throws IllegalArgumentException if it ends before it begins
     */
    public TimedPush {
        if (!(from < until)) {
            throw new IllegalArgumentException(
                    "the scheduled force '%s' must end after it begins, but acts from %s to %s s"
                            .formatted(name, from, until));
        }
    }
}
