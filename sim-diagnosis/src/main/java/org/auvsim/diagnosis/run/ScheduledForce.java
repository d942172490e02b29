package org.auvsim.diagnosis.run;

import org.auvsim.core.entity.NamedForce;

/**
 * A force that acted on the body during a run.
 *
 * @param from when it began (s)
 * @param until when it ended (s)
 */
public record ScheduledForce(double from, double until, NamedForce force) {
    /**
     * A force that acts for a while.
     *
     * @throws IllegalArgumentException if it ends before it begins
     */
    public ScheduledForce {
        if (!(from < until)) {
            throw new IllegalArgumentException(
                    "force '%s' must end after it begins, but acts from %s to %s s"
                            .formatted(force.name(), from, until));
        }
    }
}
