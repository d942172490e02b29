package org.auvsim.diagnosis.shooting;

import org.auvsim.core.math.Vec3;
import org.auvsim.server.feedback.RigidMotion;

/**
 * A motion between two instants that are near: its way and its turn run along the cubics that have
 * both ends and their rates (Hermite). Turns are rotation vectors from the first orientation on;
 * their rates are those of small ones (Bullo and Murray 1995), to the second order of the angle.
 *
 * @param duration from one to the other (s), above 0
 */
record Arc(RigidMotion begin, Cubic way, Cubic turn, double duration) {
    /** A cubic that begins at 0, by the rates at its ends and its end. */
    private record Cubic(Vec3 beginRate, Vec3 end, Vec3 endRate) {
        Vec3 at(double s, double duration) {
            return end.times(s * s * (3 - 2 * s))
                    .plus(beginRate.times(duration * s * (1 - s) * (1 - s)))
                    .minus(endRate.times(duration * s * s * (1 - s)));
        }

        Vec3 rate(double s, double duration) {
            return end.times(6 * s * (1 - s) / duration)
                    .plus(beginRate.times((1 - s) * (1 - 3 * s)))
                    .plus(endRate.times(s * (3 * s - 2)));
        }
    }

    static Arc between(RigidMotion begin, RigidMotion end, double duration) {
        double[] moved = end.minus(begin);
        Vec3 way = new Vec3(moved[0], moved[1], moved[2]);
        Vec3 turn = new Vec3(moved[3], moved[4], moved[5]);
        return new Arc(
                begin,
                new Cubic(begin.velocity(), way, end.velocity()),
                new Cubic(begin.angularVelocity(), turn, rate(turn, end.angularVelocity())),
                duration);
    }

    /** The rate of a turn, by an angular velocity. */
    private static Vec3 rate(Vec3 turn, Vec3 velocity) {
        Vec3 once = turn.cross(velocity);
        return velocity.minus(once.times(1.0 / 2)).plus(turn.cross(once).times(1.0 / 12));
    }

    /** The angular velocity, by the rate of a turn. */
    private static Vec3 velocity(Vec3 turn, Vec3 rate) {
        Vec3 once = turn.cross(rate);
        return rate.plus(once.times(1.0 / 2)).plus(turn.cross(once).times(1.0 / 6));
    }

    /** The motion at a share of the time, 0 to 1. */
    RigidMotion at(double share) {
        Vec3 moved = way.at(share, duration);
        Vec3 turned = turn.at(share, duration);
        Vec3 faster = way.rate(share, duration).minus(begin.velocity());
        Vec3 spun = velocity(turned, turn.rate(share, duration)).minus(begin.angularVelocity());
        return begin.plus(
                new double[] {
                    moved.x(), moved.y(), moved.z(), turned.x(), turned.y(), turned.z(),
                    faster.x(), faster.y(), faster.z(), spun.x(), spun.y(), spun.z()
                });
    }
}
