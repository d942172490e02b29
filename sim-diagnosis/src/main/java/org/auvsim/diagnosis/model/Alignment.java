package org.auvsim.diagnosis.model;

import org.auvsim.core.math.Quat;
import org.auvsim.core.math.Vec3;
import org.auvsim.server.feedback.RigidMotion;

/**
 * How axes of sensors, and headings, are off.
 *
 * @param turn by which the sensors' axes are off the world's (rotation vector, rad)
 * @param yaw by which orientations are off about the vertical (rad)
 * @param yawRate by which that grows (rad/s)
 * @param compass by which headings are off, on each by another angle
 */
record Alignment(Vec3 turn, double yaw, double yawRate, CompassDeviation compass) {
    /** As the world's. */
    static final Alignment EXACT = new Alignment(Vec3.ZERO, 0, 0, CompassDeviation.NONE);

    /** Both, one on top of the other. */
    Alignment plus(Alignment more) {
        return new Alignment(
                turn.plus(more.turn),
                yaw + more.yaw,
                yawRate + more.yawRate,
                compass.plus(more.compass));
    }

    /** What turns vectors of the world into those along the sensors' axes. */
    Quat axes() {
        return rotation(turn);
    }

    /** By what a heading is off besides, so long (s) after the run's beginning. */
    Quat misheading(Quat orientation, double since) {
        return rotation(new Vec3(0, 0, yaw + yawRate * since + compass.of(orientation)));
    }

    private static Quat rotation(Vec3 turn) {
        double[] change = {0, 0, 0, turn.x(), turn.y(), turn.z(), 0, 0, 0, 0, 0, 0};
        return new RigidMotion(Vec3.ZERO, Quat.IDENTITY, Vec3.ZERO, Vec3.ZERO)
                .plus(change)
                .orientation();
    }
}
