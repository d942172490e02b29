package org.auvsim.server.feedback;

import org.apache.commons.math3.linear.RealMatrix;
import org.auvsim.auvsml.message.feedback.Measurement;
import org.auvsim.core.math.Quat;
import org.auvsim.core.math.Vec3;

import java.util.Optional;
import java.util.OptionalDouble;
import java.util.function.ToDoubleFunction;

/**
 * Where an object ought to be and how it ought to move, as far as that was measured, in the world's
 * axes.
 *
 * @param position of its origin (m)
 * @param orientation unit quaternion, body to world
 * @param velocity of its origin (m/s)
 * @param angularVelocity (rad/s)
 * @param covariance of the errors of what is there, in this order; of the orientation that of a
 *     rotation vector (rad, world)
 */
public record Target(
        Optional<Vec3> position,
        Optional<Quat> orientation,
        Optional<Vec3> velocity,
        Optional<Vec3> angularVelocity,
        Optional<RealMatrix> covariance) {
    /**
     * What was measured, turned into the world's axes.
     *
     * @param model the object's motion in the simulator at the same time
     */
    static Target of(Measurement measured, RigidMotion model) {
        return new WorldAxes(measured, model).target();
    }

    /** The target after the model has moved the object from one place to another. */
    Target carried(RigidMotion from, RigidMotion to) {
        if (from.equals(to)) {
            return this;
        }
        Quat turn = to.orientation().times(from.orientation().conjugate());
        return new Target(
                position.map(p -> p.plus(to.position().minus(from.position()))),
                orientation.map(q -> turn.times(q).normalized()),
                velocity.map(v -> v.plus(to.velocity().minus(from.velocity()))),
                angularVelocity.map(
                        w -> w.plus(to.angularVelocity().minus(from.angularVelocity()))),
                covariance);
    }

    /** A motion with all that was measured in place of its own. */
    public RigidMotion replacing(RigidMotion motion) {
        return new RigidMotion(
                position.orElse(motion.position()),
                orientation.orElse(motion.orientation()),
                velocity.orElse(motion.velocity()),
                angularVelocity.orElse(motion.angularVelocity()));
    }

    /** How far a motion is from it. */
    public MeasurementErrors errors(RigidMotion motion) {
        return new MeasurementErrors(
                error(position, p -> p.distance(motion.position())),
                error(orientation, q -> Turns.between(motion.orientation(), q).norm()),
                error(velocity, v -> v.distance(motion.velocity())),
                error(angularVelocity, w -> w.distance(motion.angularVelocity())));
    }

    private static <T> OptionalDouble error(Optional<T> part, ToDoubleFunction<T> error) {
        return part.isPresent()
                ? OptionalDouble.of(error.applyAsDouble(part.get()))
                : OptionalDouble.empty();
    }
}
