package org.auvsim.auvsml.run;

/** The axes in which a run was measured. */
public enum MeasuredAxes {
    /** Those of the simulator: x east, y north, z up; of the body x forward, y left, z up. */
    ENU,
    /** x north, y east, z down; of the body x forward, y right, z down (FRD). */
    NED
}
