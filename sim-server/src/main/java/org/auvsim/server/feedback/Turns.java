package org.auvsim.server.feedback;

import org.auvsim.core.math.Quat;
import org.auvsim.core.math.Vec3;

/** Turns as rotation vectors (rad, world): an axis, as long as the angle. */
final class Turns {
    /**
     * Half an angle (rad), below which three terms of a series leave less than rounding does, and
     * need no function.
     */
    private static final double SMALL = 1e-3;

    private Turns() {}

    /** The quaternion that turns by a rotation vector. */
    static Quat of(Vec3 turn) {
        double half = turn.norm() / 2;
        double square = half * half;
        boolean isSmall = half < SMALL;
        double cosine = isSmall ? 1 - square / 2 * (1 - square / 12) : StrictMath.cos(half);
        double k =
                isSmall
                        ? (1 - square / 6 * (1 - square / 20)) / 2
                        : StrictMath.sin(half) / half / 2;
        return new Quat(cosine, turn.x() * k, turn.y() * k, turn.z() * k);
    }

    /** The shortest turn that leads from one orientation to another. */
    static Vec3 between(Quat from, Quat to) {
        Quat turn = to.times(from.conjugate());
        Vec3 axis = new Vec3(turn.x(), turn.y(), turn.z());
        double sine = axis.norm();
        double cosine = Math.abs(turn.w());
        double square = sine * sine / (cosine * cosine);
        double halfBySine =
                sine < SMALL * cosine
                        ? (1 - square / 3 * (1 - square * 3 / 5)) / cosine
                        : StrictMath.atan2(sine, cosine) / sine;
        return axis.times((turn.w() < 0 ? -2 : 2) * halfBySine);
    }
}
