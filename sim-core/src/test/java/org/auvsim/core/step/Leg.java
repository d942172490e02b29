package org.auvsim.core.step;

import org.auvsim.core.math.Draws;
import org.auvsim.core.math.Quat;
import org.auvsim.core.math.Vec3;
import org.auvsim.core.volume.Pose;

/** How a body moves at both ends of a segment from 0 to 1 s, for tests. */
record Leg(Vec3 p0, Vec3 v0, Vec3 p1, Vec3 v1, Quat q0, Vec3 w0, Quat q1, Vec3 w1) {
    /** Flies straight from one place to another, turning evenly. */
    static Leg straight(Vec3 p0, Vec3 p1, Quat q0, Vec3 w) {
        Vec3 v = p1.minus(p0);
        return new Leg(p0, v, p1, v, q0, w, turned(q0, w), w);
    }

    /** Starts and ends within {@code size} (m) of the origin, and turns by up to {@code spin}. */
    static Leg drawn(Draws draws, double size, double spin) {
        Quat q0 = draws.orientation();
        Vec3 w0 = draws.vector(spin);
        Vec3 w1 = draws.vector(spin);
        return new Leg(
                draws.vector(size),
                draws.vector(size),
                draws.vector(size),
                draws.vector(size),
                q0,
                w0,
                turned(q0, w0.plus(w1).times(0.5)),
                w1);
    }

    static BodyCurve standing(Vec3 place, Quat orientation) {
        BodyCurve curve = new BodyCurve();
        curve.rest(0, 1, Pose.of(place, orientation));
        return curve;
    }

    private static Quat turned(Quat q0, Vec3 turn) {
        return turn.norm() > 0 ? Quat.ofAxisAngle(turn, turn.norm()).times(q0) : q0;
    }

    /** The same places the other way round. */
    Leg backward() {
        return new Leg(p1, v1.negated(), p0, v0.negated(), q1, w1.negated(), q0, w0.negated());
    }

    BodyCurve curve() {
        BodyCurve curve = new BodyCurve();
        Vec3 a = p0.plus(v0.times(1.0 / 3));
        Vec3 b = p1.minus(v1.times(1.0 / 3));
        double[] points = {
            p0.x(), p0.y(), p0.z(), a.x(), a.y(), a.z(), b.x(), b.y(), b.z(), p1.x(), p1.y(), p1.z()
        };
        curve.path(0, 1, points, 0);
        curve.turnFrom(q0.w(), q0.x(), q0.y(), q0.z(), w0.x(), w0.y(), w0.z());
        curve.turnTo(q1.w(), q1.x(), q1.y(), q1.z(), w1.x(), w1.y(), w1.z());
        return curve;
    }
}
