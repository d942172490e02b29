package org.auvsim.server.feedback;

import org.auvsim.core.entity.MovementState;
import org.auvsim.core.entity.Twist;
import org.auvsim.core.entity.WorldObject;
import org.auvsim.core.math.Quat;
import org.auvsim.core.math.Vec3;

/**
 * Where a rigid body is and how it moves, in the world's axes.
 *
 * @param position of its origin (m)
 * @param orientation unit quaternion, body to world
 * @param velocity of its origin (m/s)
 * @param angularVelocity (rad/s)
 */
public record RigidMotion(Vec3 position, Quat orientation, Vec3 velocity, Vec3 angularVelocity) {
    /** How many numbers the error of a motion has. */
    public static final int SIZE = 12;

    /** That of an object now. */
    public static RigidMotion of(WorldObject object) {
        MovementState state = object.movementState();
        Twist twist = object.twistOf(state);
        return new RigidMotion(
                state.position(), state.orientation(), twist.velocity(), twist.angularVelocity());
    }

    /** Lets an object move so. */
    public void giveTo(WorldObject object) {
        object.setPosition(position);
        object.setOrientation(orientation);
        object.setTwist(new Twist(velocity, angularVelocity));
    }

    /**
     * The motion at a share of the time between two others: the position runs along the cubic that
     * has both positions and velocities (Hermite), the velocity is its derivative, the orientation
     * turns evenly the shorter way, the angular velocity changes evenly.
     *
     * @param duration from one to the other (s)
     * @param share 0 for the first to 1 for the second
     */
    static RigidMotion between(RigidMotion a, RigidMotion b, double duration, double share) {
        double s = share;
        Vec3 way = b.position.minus(a.position);
        Vec3 atStart = a.velocity.times(duration);
        Vec3 atEnd = b.velocity.times(duration);
        Vec3 position =
                a.position
                        .plus(way.times(s * s * (3 - 2 * s)))
                        .plus(atStart.times(s * (1 - s) * (1 - s)))
                        .minus(atEnd.times(s * s * (1 - s)));
        Vec3 slope =
                way.times(6 * s * (1 - s))
                        .plus(atStart.times((1 - s) * (1 - 3 * s)))
                        .plus(atEnd.times(s * (3 * s - 2)));
        Vec3 turn = Turns.between(a.orientation, b.orientation);
        return new RigidMotion(
                position,
                Turns.of(turn.times(s)).times(a.orientation).normalized(),
                duration > 0 ? slope.times(1 / duration) : b.velocity,
                a.angularVelocity.times(1 - s).plus(b.angularVelocity.times(s)));
    }

    /**
     * The motion that is off by an error: position (m), turn (rotation vector, rad), velocity (m/s)
     * and angular velocity (rad/s), all in the world's axes.
     *
     * @param error twelve numbers
     */
    public RigidMotion plus(double[] error) {
        return new RigidMotion(
                position.plus(vector(error, 0)),
                Turns.of(vector(error, 3)).times(orientation).normalized(),
                velocity.plus(vector(error, 6)),
                angularVelocity.plus(vector(error, 9)));
    }

    /** The error by which this differs from another motion: twelve numbers. */
    public double[] minus(RigidMotion o) {
        Vec3 way = position.minus(o.position);
        Vec3 turn = Turns.between(o.orientation, orientation);
        Vec3 v = velocity.minus(o.velocity);
        Vec3 w = angularVelocity.minus(o.angularVelocity);
        return new double[] {
            way.x(), way.y(), way.z(), turn.x(), turn.y(), turn.z(),
            v.x(), v.y(), v.z(), w.x(), w.y(), w.z()
        };
    }

    private static Vec3 vector(double[] numbers, int from) {
        return new Vec3(numbers[from], numbers[from + 1], numbers[from + 2]);
    }
}
