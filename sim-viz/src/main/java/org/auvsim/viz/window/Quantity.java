package org.auvsim.viz.window;

import java.awt.Color;

/** What of an object's motion is plotted. */
enum Quantity {
    X("x", 0.02, 0xE5734F),
    Y("y", 0.02, 0x5BB974),
    DEPTH("depth", 0.02, 0x4F9BE5),
    SPEED("speed", 0.02, 0xD9A441),
    YAW("yaw", 1, 0xB57EDC);

    private final String word;
    private final double span;
    private final Color colour;

    Quantity(String word, double span, int colour) {
        this.word = word;
        this.span = span;
        this.colour = new Color(colour);
    }

    String word() {
        return word;
    }

    /** The height of its plot is at least this (m, m/s, degrees): less is hardly a change. */
    double span() {
        return span;
    }

    Color colour() {
        return colour;
    }
}
