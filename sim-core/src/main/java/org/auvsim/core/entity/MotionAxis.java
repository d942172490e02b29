package org.auvsim.core.entity;

/** The six directions of a body's motion (SNAME 1950). */
public enum MotionAxis {
    SURGE(0),
    SWAY(1),
    HEAVE(2),
    ROLL(3),
    PITCH(4),
    YAW(5);

    private final int index;

    MotionAxis(int index) {
        this.index = index;
    }

    /** Its row or column in a 6x6 matrix. */
    public int index() {
        return index;
    }
}
