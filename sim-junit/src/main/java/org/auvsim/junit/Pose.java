package org.auvsim.junit;

import org.auvsim.core.math.Mat3;
import org.auvsim.core.math.Quat;
import org.auvsim.core.math.Vec3;

/** Where a recording has a body at a time (s): position (m, world), orientation, body to world. */
record Pose(double time, Vec3 position, Mat3 orientation) {
    /**
     * The angle (rad) of the turn from this orientation to another one; of two rotation matrices a
     * turn of that angle apart, the squared differences sum up to 8 sin^2 (angle / 2).
     */
    double angle(Quat other) {
        Mat3 o = other.toMatrix();
        double squares =
                square(orientation.xx() - o.xx())
                        + square(orientation.xy() - o.xy())
                        + square(orientation.xz() - o.xz())
                        + square(orientation.yx() - o.yx())
                        + square(orientation.yy() - o.yy())
                        + square(orientation.yz() - o.yz())
                        + square(orientation.zx() - o.zx())
                        + square(orientation.zy() - o.zy())
                        + square(orientation.zz() - o.zz());
        return 2 * Math.asin(Math.min(1, Math.sqrt(squares / 8)));
    }

    private static double square(double x) {
        return x * x;
    }
}
