package org.auvsim.viz.drawing;

/** What can be shown or left out, and its name for people. */
public enum Layer {
    /** Lines on the ground, a square every metre, ten metres or so. */
    GRID("Grid"),
    /** The world's axes: x red, y green, z blue. */
    AXES("Axes"),
    /** The surface of the water, waves included. */
    WATER("Water surface"),
    /** Where objects have been. */
    TRAILS("Trails"),
    /** Where the step under way will bring objects. */
    GHOSTS("Projected states"),
    /** Where robots measured that they are. */
    MEASUREMENTS("Measured positions"),
    /** How fast objects move: where they would be in a second. */
    VELOCITIES("Velocities"),
    /** What pushes objects: named forces and propulsors. */
    FORCES("Forces"),
    /** How the water moves. */
    CURRENTS("Currents"),
    /** Where sonars and velocity logs look. */
    SENSORS("Sensor beams"),
    /** Where objects have just met. */
    CONTACTS("Collisions"),
    /** The names of objects. */
    LABELS("Names");

    private final String title;

    Layer(String title) {
        this.title = title;
    }

    /** Its name for people. */
    public String title() {
        return title;
    }
}
