package org.auvsim.viz.window;

import java.util.Locale;

/** What a picture may show beside the objects themselves. */
public enum Shown {
    /** Where the step under way will bring each object. */
    GHOSTS("Ghosts of the coming step", 'G'),
    /** Where each object has been. */
    TRAILS("Trails", 'T'),
    /** Velocities. */
    VELOCITIES("Velocity arrows", 'V'),
    /** Forces that somebody has set. */
    FORCES("Force arrows", 'O'),
    /** Currents and other fields. */
    CURRENTS("Currents", 'U'),
    /** Sensors and what they see. */
    SENSORS("Sensors", 'N'),
    /** Names beside the objects. */
    LABELS("Names", 'L'),
    /** A grid to measure by. */
    GRID("Grid", 'I'),
    /** The water's surface. */
    WATER("Water surface", 'W'),
    /** Where robots measured that they are. */
    MEASURED("Measured positions", 'M');

    private final String words;
    private final char key;

    Shown(String words, char key) {
        this.words = words;
        this.key = key;
    }

    /** What a menu calls it. */
    String words() {
        return words;
    }

    /** The key that turns it on and off, with Alt and Shift. */
    char key() {
        return key;
    }

    /** What a component that turns it on and off is called. */
    String componentName() {
        return "show-" + name().toLowerCase(Locale.ROOT);
    }
}
