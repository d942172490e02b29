package org.auvsim.diagnosis.run;

import org.auvsim.core.math.Vec3;
import org.auvsim.server.feedback.RigidMotion;

import java.util.List;
import java.util.stream.IntStream;

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

    /** The same; what nothing is known of is as in another motion. */
    public KnownStart orElse(RigidMotion otherwise) {
        boolean isTurnKnown = IntStream.range(3, 6).anyMatch(this::isKnown);
        return new KnownStart(
                new RigidMotion(
                        known(0, motion.position(), otherwise.position()),
                        isTurnKnown ? motion.orientation() : otherwise.orientation(),
                        known(6, motion.velocity(), otherwise.velocity()),
                        known(9, motion.angularVelocity(), otherwise.angularVelocity())),
                deviations);
    }

    private Vec3 known(int from, Vec3 known, Vec3 otherwise) {
        return new Vec3(
                isKnown(from) ? known.x() : otherwise.x(),
                isKnown(from + 1) ? known.y() : otherwise.y(),
                isKnown(from + 2) ? known.z() : otherwise.z());
    }

    /** Whether anything is known of one of the twelve numbers. */
    public boolean isKnown(int number) {
        return Double.isFinite(deviations.get(number));
    }
}
