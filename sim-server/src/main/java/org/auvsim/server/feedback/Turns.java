package org.auvsim.server.feedback;

import org.auvsim.core.math.Quat;
import org.auvsim.core.math.Vec3;

/** Turns as rotation vectors (rad, world): an axis, as long as the angle. */
final class Turns {
    /** Half an angle, below which its sine is the angle itself. */
    private static final double SMALL = 1e-9;

    private Turns() {}

    /** The quaternion that turns by a rotation vector. */
    static Quat of(Vec3 turn) {
        double half = turn.norm() / 2;
        double k = half > SMALL ? StrictMath.sin(half) / half / 2 : 0.5;
        return new Quat(StrictMath.cos(half), turn.x() * k, turn.y() * k, turn.z() * k);
    }

    /** The shortest turn that leads from one orientation to another. */
    static Vec3 between(Quat from, Quat to) {
        Quat turn = to.times(from.conjugate());
        Vec3 axis = new Vec3(turn.x(), turn.y(), turn.z());
        double sine = axis.norm();
        double sign = turn.w() < 0 ? -1 : 1;
        double half = StrictMath.atan2(sine, sign * turn.w());
        return axis.times(sign * (sine > SMALL ? 2 * half / sine : 2));
    }
}
