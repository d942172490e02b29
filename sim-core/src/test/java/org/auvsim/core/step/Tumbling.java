package org.auvsim.core.step;

import org.auvsim.core.math.Mat3;
import org.auvsim.core.math.Quat;
import org.auvsim.core.math.Vec3;

/**
 * A body that turns without torque, by Euler's equations in body axes, independent of the
 * simulator's own in momenta.
 *
 * @param inertia diagonal, body axes (kg m^2)
 * @param spin angular velocity in body axes (rad/s)
 */
record Tumbling(Mat3 inertia, Quat orientation, Vec3 spin) {
    private static final double STEP = 1e-4;

    Vec3 angularVelocity() {
        return orientation.rotate(spin);
    }

    /** Classical Runge-Kutta in steps of 0.1 ms or less. */
    Tumbling after(double time) {
        int steps = (int) Math.ceil(time / STEP) + 1;
        Tumbling now = this;
        for (int i = 0; i < steps; i++) {
            now = now.step(time / steps);
        }
        return now;
    }

    private Tumbling step(double h) {
        Tumbling a = rate();
        Tumbling b = plus(a, h / 2).rate();
        Tumbling c = plus(b, h / 2).rate();
        Tumbling d = plus(c, h).rate();
        return plus(a, h / 6).plus(b, h / 3).plus(c, h / 3).plus(d, h / 6).normalized();
    }

    private Tumbling normalized() {
        return new Tumbling(inertia, orientation.normalized(), spin);
    }

    /** The derivatives of orientation and spin. */
    private Tumbling rate() {
        Quat w = new Quat(0, spin.x() / 2, spin.y() / 2, spin.z() / 2);
        Vec3 torque = inertia.times(spin).cross(spin);
        Vec3 dw =
                new Vec3(
                        torque.x() / inertia.xx(),
                        torque.y() / inertia.yy(),
                        torque.z() / inertia.zz());
        return new Tumbling(inertia, orientation.times(w), dw);
    }

    private Tumbling plus(Tumbling rate, double h) {
        Quat q = orientation;
        Quat d = rate.orientation;
        Quat next =
                new Quat(
                        q.w() + h * d.w(), q.x() + h * d.x(), q.y() + h * d.y(), q.z() + h * d.z());
        return new Tumbling(inertia, next, spin.plus(rate.spin.times(h)));
    }
}
