package org.auvsim.cli.export;

import org.auvsim.core.math.Mat3;
import org.auvsim.core.math.Quat;

/** Orientations as quaternions, of which the tables have fewer numbers than of matrices. */
final class Orientation {
    private Orientation() {}

    /**
     * The unit quaternion of a rotation matrix, from the largest of its four squares (Shepperd
     * 1978, J. Guidance and Control 1); of q and -q the one with w of 0 or more.
     */
    static Quat of(Mat3 m) {
        double trace = m.xx() + m.yy() + m.zz();
        double largest = Math.max(Math.max(trace, m.xx()), Math.max(m.yy(), m.zz()));
        Quat q;
        if (largest == trace) {
            q = new Quat(1 + trace, m.zy() - m.yz(), m.xz() - m.zx(), m.yx() - m.xy());
        } else if (largest == m.xx()) {
            double x = 1 + m.xx() - m.yy() - m.zz();
            q = new Quat(m.zy() - m.yz(), x, m.xy() + m.yx(), m.xz() + m.zx());
        } else if (largest == m.yy()) {
            double y = 1 + m.yy() - m.xx() - m.zz();
            q = new Quat(m.xz() - m.zx(), m.xy() + m.yx(), y, m.yz() + m.zy());
        } else {
            double z = 1 + m.zz() - m.xx() - m.yy();
            q = new Quat(m.yx() - m.xy(), m.xz() + m.zx(), m.yz() + m.zy(), z);
        }
        Quat unit = q.normalized();
        return unit.w() < 0 ? new Quat(-unit.w(), -unit.x(), -unit.y(), -unit.z()) : unit;
    }
}
