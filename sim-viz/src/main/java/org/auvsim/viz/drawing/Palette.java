package org.auvsim.viz.drawing;

import org.auvsim.viz.scene.SeenObject;

/**
 * The colours of a picture, 0xAARRGGBB.
 *
 * @param background behind everything
 * @param ground the sea floor, walls
 * @param fixed what never moves
 * @param grid lines on the ground
 * @param water its surface
 * @param words of labels
 * @param chosen what is selected
 */
public record Palette(
        int background, int ground, int fixed, int grid, int water, int words, int chosen) {
    /** Light things before a dark sea. */
    public static final Palette DARK =
            new Palette(
                    0xff10202c,
                    0xff4a4a3e,
                    0xff7c8288,
                    0xff35505f,
                    0x402a7fb0,
                    0xffe6edf2,
                    0xffffd23f);

    /** Dark things before a light sky. */
    public static final Palette LIGHT =
            new Palette(
                    0xffe9f1f6,
                    0xffcfc4a6,
                    0xff8d949a,
                    0xffa9bcc8,
                    0x403d9bd0,
                    0xff17242d,
                    0xffd98a00);

    /** Where the step will bring an object: this much shows. */
    static final int GHOST_ALPHA = 0x60;

    static final int X_AXIS = 0xffe0504a;
    static final int Y_AXIS = 0xff4fb35c;
    static final int Z_AXIS = 0xff4b83e8;
    static final int VELOCITY = 0xff38c7c0;
    static final int FORCE = 0xffff6f4d;
    static final int THRUST = 0xffffa43d;
    static final int CURRENT = 0x605ab4e6;
    static final int SENSOR = 0x90b58df0;
    static final int MEASURED = 0xffff4fa3;
    static final int CONTACT = 0xffffee66;

    private static final int[] OBJECTS = {
        0xfff2a33a,
        0xff5aa9e6,
        0xff7fd069,
        0xffe5717a,
        0xffb08bea,
        0xff4fc9b8,
        0xffe6c84f,
        0xffe58fc6,
        0xff9aa7f0,
        0xffc2a283,
    };

    private static final String[] NAMED = {
        "red", "green", "blue", "yellow", "orange", "white", "black", "purple",
    };

    private static final int[] NAMED_COLOURS = {
        0xffe0504a,
        0xff58b865,
        0xff4b83e8,
        0xffe6c84f,
        0xfff2933a,
        0xfff2f2f2,
        0xff3a3d40,
        0xffa070e0,
    };

    /** The colour of an object that moves: what its name says, or one of ten by its id. */
    static int of(SeenObject object) {
        for (int i = 0; i < NAMED.length; i++) {
            if (object.name()
                    .regionMatches(/* ignoreCase= */ true, 0, NAMED[i], 0, NAMED[i].length())) {
                return NAMED_COLOURS[i];
            }
        }
        return OBJECTS[(int) Math.floorMod(object.id(), (long) OBJECTS.length)];
    }

    /** A colour, to be seen through. */
    static int faded(int colour, int alpha) {
        return (colour & 0x00ffffff) | (alpha << 24);
    }
}
