package org.auvsim.viz.scene;

import org.auvsim.core.math.Mat3;
import org.auvsim.core.math.Quat;

/** Orientations as people say them. */
public final class Angles {
    private Angles() {}

    /**
     * Roll, pitch and yaw (rad): about the body's x after y after z; a pitch above 0 lifts the bow.
     */
    public static double[] rollPitchYaw(Quat orientation) {
        Mat3 m = orientation.toMatrix();
        return new double[] {
            Math.atan2(m.zy(), m.zz()),
            Math.asin(Math.clamp(m.zx(), -1, 1)),
            Math.atan2(m.yx(), m.xx())
        };
    }
}
