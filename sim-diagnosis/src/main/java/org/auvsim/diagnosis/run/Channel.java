package org.auvsim.diagnosis.run;

/** What can be measured of a body's motion; each has three numbers. */
public enum Channel {
    /** Of the origin (m, world). */
    POSITION,
    /** As a rotation vector (rad). */
    ORIENTATION,
    /** Of the origin (m/s, world). */
    VELOCITY,
    /** In the world's axes (rad/s). */
    ANGULAR_VELOCITY
}
