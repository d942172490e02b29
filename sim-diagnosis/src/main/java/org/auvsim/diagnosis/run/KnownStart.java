package org.auvsim.diagnosis.run;

import org.auvsim.server.feedback.RigidMotion;

import java.util.List;

/**
 * How a body moved at the beginning of a run, as far as that is known.
 *
 * @param deviations standard deviations of position (m), rotation vector (rad), velocity (m/s) and
 *     angular velocity (rad/s), world axes: twelve numbers above 0, infinite where nothing is known
 */
public record KnownStart(RigidMotion motion, List<Double> deviations) {
    /**
     * A checked start.
     *
     * @throws IllegalArgumentException if there are not twelve deviations above 0
     */
    public KnownStart {
        deviations = List.copyOf(deviations);
        if (deviations.size() != RigidMotion.SIZE || deviations.stream().anyMatch(d -> !(d > 0))) {
            throw new IllegalArgumentException(
                    "a known start needs %d standard deviations above 0, but has %s"
                            .formatted(RigidMotion.SIZE, deviations));
        }
    }
}
