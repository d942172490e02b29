package org.auvsim.core.sensor;

import org.auvsim.core.entity.RigidBody;
import org.auvsim.core.entity.Twist;
import org.auvsim.core.math.Quat;
import org.auvsim.core.math.Vec3;

/**
 * Where something is and how it moves at an instant.
 *
 * @param time of the world (s)
 * @param position of its origin (m, world)
 * @param orientation unit quaternion, its axes to the world's
 * @param velocity of its origin (m/s, world)
 * @param angularVelocity (rad/s, world)
 */
public record Kinematics(
        double time, Vec3 position, Quat orientation, Vec3 velocity, Vec3 angularVelocity) {
    /** Those of a body in its present state, which is that of a time (s). */
    public static Kinematics of(RigidBody body, double time) {
        Twist twist = body.twist();
        return new Kinematics(
                time,
                body.position(),
                body.orientation(),
                twist.velocity(),
                twist.angularVelocity());
    }

    /**
     * Those of a place that is fixed to this body.
     *
     * @param place (m, body coordinates)
     * @param axes from the place's axes to the body's
     */
    public Kinematics at(Vec3 place, Quat axes) {
        Vec3 arm = orientation.rotate(place);
        return new Kinematics(
                time,
                position.plus(arm),
                orientation.times(axes),
                velocity.plus(angularVelocity.cross(arm)),
                angularVelocity);
    }

    /**
     * Those at a time (s) between this and a later one: the position on the cubic that has the
     * places and velocities of both ends, the orientation on the normalised cubic of the
     * quaternion, with dq/dt = 1/2 [0, w] q at both ends. Without a collision in between it errs by
     * the fourth order of the interval.
     */
    public Kinematics toward(Kinematics end, double at) {
        double h = end.time - time;
        double s = (at - time) / h;
        Quat last =
                dot(orientation, end.orientation) < 0 ? negated(end.orientation) : end.orientation;
        Quat slope0 = rate(orientation, angularVelocity);
        Quat slope1 = rate(last, end.angularVelocity);
        Quat q = cubic(orientation, slope0, last, slope1, h, s);
        Quat dq = slope(orientation, slope0, last, slope1, h, s);
        return new Kinematics(
                at,
                position.times(first(s))
                        .plus(velocity.times(h * firstRate(s)))
                        .plus(end.position.times(1 - first(s)))
                        .plus(end.velocity.times(h * lastRate(s))),
                q.normalized(),
                end.position
                        .minus(position)
                        .times(6 * s * (1 - s) / h)
                        .plus(velocity.times((1 - s) * (1 - 3 * s)))
                        .plus(end.velocity.times(s * (3 * s - 2))),
                spin(q, dq));
    }

    /** Hermite's cubics: the share of the first value, and of the two rates. */
    private static double first(double s) {
        return (1 - s) * (1 - s) * (1 + 2 * s);
    }

    private static double firstRate(double s) {
        return s * (1 - s) * (1 - s);
    }

    private static double lastRate(double s) {
        return s * s * (s - 1);
    }

    private static Quat cubic(Quat a, Quat da, Quat b, Quat db, double h, double s) {
        return sum(a, first(s), da, h * firstRate(s), b, 1 - first(s), db, h * lastRate(s));
    }

    private static Quat slope(Quat a, Quat da, Quat b, Quat db, double h, double s) {
        double rise = 6 * s * (1 - s) / h;
        return sum(a, -rise, da, (1 - s) * (1 - 3 * s), b, rise, db, s * (3 * s - 2));
    }

    private static Quat sum(
            Quat a, double ka, Quat b, double kb, Quat c, double kc, Quat d, double kd) {
        return new Quat(
                ka * a.w() + kb * b.w() + kc * c.w() + kd * d.w(),
                ka * a.x() + kb * b.x() + kc * c.x() + kd * d.x(),
                ka * a.y() + kb * b.y() + kc * c.y() + kd * d.y(),
                ka * a.z() + kb * b.z() + kc * c.z() + kd * d.z());
    }

    private static Quat rate(Quat q, Vec3 w) {
        Quat product = new Quat(0, w.x(), w.y(), w.z()).times(q);
        return new Quat(product.w() / 2, product.x() / 2, product.y() / 2, product.z() / 2);
    }

    /** w of dq/dt = 1/2 [0, w] q, for the direction of a quaternion of any length. */
    private static Vec3 spin(Quat q, Quat dq) {
        Quat product = dq.times(q.conjugate());
        double scale = 2 / dot(q, q);
        return new Vec3(product.x(), product.y(), product.z()).times(scale);
    }

    private static double dot(Quat a, Quat b) {
        return a.w() * b.w() + a.x() * b.x() + a.y() * b.y() + a.z() * b.z();
    }

    private static Quat negated(Quat q) {
        return new Quat(-q.w(), -q.x(), -q.y(), -q.z());
    }
}
