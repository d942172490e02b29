package org.auvsim.experiments.hidden;

import org.apache.commons.math3.geometry.euclidean.threed.Vector3D;

/**
 * What sensors make of a motion.
 *
 * @param delay how old it is when told (s), below 0: told ahead by a clock that is wrong
 * @param scale of coordinates, less 1
 * @param turn of the sensors' axes against the world's (rotation vector, rad)
 * @param yaw by which orientations are off (rad)
 * @param yawRate by which that grows (rad/s)
 */
record Sensors(double delay, Vector3D scale, Vector3D turn, double yaw, double yawRate) {
    static final Sensors TRUE = new Sensors(0, Vector3D.ZERO, Vector3D.ZERO, 0, 0);

    /** What is told at a time (s) of a motion that was so {@link #delay} before. */
    Pose told(Instant then, double time) {
        Vector3D p = then.position();
        Attitude axes = Attitude.turned(turn);
        Attitude heading = Attitude.turned(new Vector3D(0, 0, yaw + yawRate * time));
        Vector3D scaled =
                new Vector3D(
                        p.getX() * (1 + scale.getX()),
                        p.getY() * (1 + scale.getY()),
                        p.getZ() * (1 + scale.getZ()));
        return new Pose(
                axes.toWorld(scaled), heading.after(axes).after(then.attitude()).normalized());
    }
}
