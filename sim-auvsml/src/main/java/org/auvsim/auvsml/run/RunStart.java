package org.auvsim.auvsml.run;

import org.auvsim.core.description.Unit;
import org.auvsim.core.entity.Domain;
import org.auvsim.core.math.Quat;
import org.auvsim.core.math.Vec3;

import java.util.Optional;

/**
 * How a body moved at the first row of a run. What is left out is not known.
 *
 * @param position of its origin
 * @param orientation body to world
 * @param velocity of its origin
 * @param angularVelocity in world axes
 */
public record RunStart(
        @Unit("m") Optional<KnownVector> position,
        Optional<KnownOrientation> orientation,
        @Unit("m/s") Optional<KnownVector> velocity,
        @Unit("rad/s") Optional<KnownVector> angularVelocity) {
    /**
     * A vector and how far it may be off.
     *
     * @param deviation standard deviation of each coordinate, in the vector's unit
     */
    public record KnownVector(double x, double y, double z, double deviation) {
        /**
         * A checked vector.
         *
         * @throws IllegalArgumentException if the deviation is not above 0
         */
        public KnownVector {
            Domain.above0("a known start", "deviation", deviation, "");
        }

        /** Without the deviation. */
        public Vec3 vector() {
            return new Vec3(x, y, z);
        }
    }

    /**
     * An orientation and how far it may be off.
     *
     * @param deviation standard deviation of each component of the rotation vector
     */
    public record KnownOrientation(
            double w, double x, double y, double z, @Unit("rad") double deviation) {
        /**
         * A checked orientation.
         *
         * @throws IllegalArgumentException if the quaternion is 0 or the deviation is not above 0
         */
        public KnownOrientation {
            Domain.unit("a known start", "orientation", new Quat(w, x, y, z));
            Domain.above0("a known start", "deviation", deviation, "rad");
        }

        /** Of length 1, without the deviation. */
        public Quat quaternion() {
            return new Quat(w, x, y, z).normalized();
        }
    }
}
