package org.auvsim.diagnosis.run;

import org.auvsim.core.math.Quat;
import org.auvsim.core.math.Vec3;

/** Roll, pitch and yaw (rad): turns about z, then the new y, then the new x (Fossen 2011, 2.2). */
public final class EulerAngles {
    private EulerAngles() {}

    /** The orientation with these angles, body to world. */
    public static Quat orientation(double roll, double pitch, double yaw) {
        return Quat.ofAxisAngle(new Vec3(0, 0, 1), yaw)
                .times(Quat.ofAxisAngle(new Vec3(0, 1, 0), pitch))
                .times(Quat.ofAxisAngle(new Vec3(1, 0, 0), roll));
    }

    /** The angles of an orientation, as x, y and z. */
    public static Vec3 of(Quat q) {
        double sine = 2 * (q.w() * q.y() - q.z() * q.x());
        return new Vec3(
                StrictMath.atan2(
                        2 * (q.w() * q.x() + q.y() * q.z()),
                        1 - 2 * (q.x() * q.x() + q.y() * q.y())),
                StrictMath.asin(Math.max(-1, Math.min(1, sine))),
                StrictMath.atan2(
                        2 * (q.w() * q.z() + q.x() * q.y()),
                        1 - 2 * (q.y() * q.y() + q.z() * q.z())));
    }
}
