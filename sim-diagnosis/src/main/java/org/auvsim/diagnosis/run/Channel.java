package org.auvsim.diagnosis.run;

/** What can be measured of a body's motion; each has three numbers. */
public enum Channel {
    /** Of the origin (m, world). */
    POSITION("position", "m"),
    /** As a rotation vector (rad). */
    ORIENTATION("orientation", "rad"),
    /** Of the origin (m/s, world). */
    VELOCITY("velocity", "m/s"),
    /** In the world's axes (rad/s). */
    ANGULAR_VELOCITY("angular velocity", "rad/s");

    private final String words;
    private final String unit;

    Channel(String words, String unit) {
        this.words = words;
        this.unit = unit;
    }

    /** Its name for people. */
    public String words() {
        return words;
    }

    /** The unit of its numbers. */
    public String unit() {
        return unit;
    }
}
