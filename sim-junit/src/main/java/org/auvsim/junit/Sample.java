package org.auvsim.junit;

import org.auvsim.core.math.Quat;
import org.auvsim.core.math.Vec3;

/**
 * A body at an instant.
 *
 * @param time world time (s)
 * @param position of its origin (m, world)
 * @param orientation body to world
 * @param velocity of its origin (m/s, world)
 * @param angularVelocity (rad/s, world)
 */
public record Sample(
        double time, Vec3 position, Quat orientation, Vec3 velocity, Vec3 angularVelocity) {
    /**
     * The body between this sample and a later one, all numbers linear in time. Half-way through a
     * step of h the position is off by the acceleration times h^2 / 8.
     */
    Sample towards(Sample later, double time) {
        double share = (time - this.time) / (later.time - this.time);
        return new Sample(
                time,
                between(position, later.position, share),
                between(orientation, later.orientation, share),
                between(velocity, later.velocity, share),
                between(angularVelocity, later.angularVelocity, share));
    }

    private static Vec3 between(Vec3 from, Vec3 to, double share) {
        return from.plus(to.minus(from).times(share));
    }

    /** Along the chord, the shorter way round: q and -q are the same orientation. */
    private static Quat between(Quat from, Quat to, double share) {
        double dot = from.w() * to.w() + from.x() * to.x() + from.y() * to.y() + from.z() * to.z();
        double b = dot < 0 ? -share : share;
        double a = 1 - share;
        return new Quat(
                        a * from.w() + b * to.w(),
                        a * from.x() + b * to.x(),
                        a * from.y() + b * to.y(),
                        a * from.z() + b * to.z())
                .normalized();
    }
}
