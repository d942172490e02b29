package org.auvsim.auvsml.message.feedback;

/** The axes in which a robot states what it measured. */
public enum MeasurementFrame {
    /** The world's own: x east, y north, z up; orientations of a body with x forward, z up. */
    WORLD,
    /**
     * x north, y east, z down; orientations of a body with x forward, y right, z down, as ships and
     * underwater vehicles use them.
     */
    NED,
    /**
     * Relative to the object in the simulator at that time, in its own axes (x forward, y left, z
     * up): a position is the way from it, an orientation the turn from it. Velocities are those
     * over ground, in the robot's own axes.
     */
    BODY
}
