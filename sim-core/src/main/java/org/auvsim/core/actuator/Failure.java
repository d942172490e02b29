package org.auvsim.core.actuator;

import org.auvsim.core.description.Default;
import org.auvsim.core.description.Unit;
import org.auvsim.core.entity.Domain;
import org.auvsim.core.math.Rise;

/**
 * The loss of a propulsor's thrust, or of a share of it. It fades within a short time about an
 * instant, as a jump inside a time step would be integrated wrongly.
 *
 * @param from the middle of the fading (s, the world's time)
 * @param left share of the thrust afterwards, 0 or more
 * @param fade how long it takes (s), 0 or more; two time steps or more are integrated exactly
 */
public record Failure(
        @Unit("s") double from,
        @Default("0.0") double left,
        @Unit("s") @Default("0.1") double fade) {
    /**
     * A checked failure.
     *
     * @throws IllegalArgumentException naming the number that is out of its range
     */
    public Failure {
        Domain.finite("the failure of a propulsor", "time", from, "s");
        Domain.atLeast0("the failure of a propulsor", "share left", left, "");
        Domain.atLeast0("the failure of a propulsor", "fade", fade, "s");
    }

    /** The share of the thrust that is left at a time (s). */
    double leftAt(double time) {
        return 1 - (1 - left) * Rise.share(time, from, fade);
    }
}
