package org.auvsim.viz.drawing;

/** What can be shown or left out. */
public enum Layer {
    /** Lines on the ground, a square every metre, ten metres or so. */
    GRID("Grid", "Grid", 'I'),
    /** The world's axes: x red, y green, z blue. */
    AXES("Axes", "Axes of the world", 'X'),
    /** The surface of the water, waves included. */
    WATER("Water", "Water surface", 'W'),
    /** Where objects have been. */
    TRAILS("Trails", "Trails", 'T'),
    /** Where the step under way will bring objects. */
    GHOSTS("Ghosts", "Ghosts: projected states", 'G'),
    /** Where robots measured that they are. */
    MEASUREMENTS("Measured", "Measured positions", 'M'),
    /** How fast objects move: where they would be in a second. */
    VELOCITIES("Velocity", "Velocity arrows", 'V'),
    /** What pushes objects: named forces and propulsors. */
    FORCES("Force", "Force arrows", 'O'),
    /** How the water moves. */
    CURRENTS("Current", "Currents", 'U'),
    /** Where sonars and velocity logs look. */
    SENSORS("Beams", "Sensor beams", 'N'),
    /** Where objects have just met. */
    CONTACTS("Hits", "Collisions", 'C'),
    /** The names of objects. */
    LABELS("Names", "Names", 'L');

    private final String word;
    private final String title;
    private final char key;

    Layer(String word, String title, char key) {
        this.word = word;
        this.title = title;
        this.key = key;
    }

    /** Its name in a word, for a button. */
    public String word() {
        return word;
    }

    /** Its name for a menu. */
    public String title() {
        return title;
    }

    /** The letter that shows it or leaves it out, with Alt and Shift. */
    public char key() {
        return key;
    }
}
