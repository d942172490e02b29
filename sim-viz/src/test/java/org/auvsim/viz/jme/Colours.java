package org.auvsim.viz.jme;

import java.awt.Color;
import java.awt.image.BufferedImage;

/** What colour a pixel is, whatever the light on it. */
public final class Colours {
    private Colours() {}

    /** Whether a pixel has the hue of a colour, to a twentieth of the circle, and is no grey. */
    public static boolean hasHue(BufferedImage picture, double[] pixel, int colour) {
        float[] seen = parts(rgb(picture, pixel));
        float difference = Math.abs(seen[0] - parts(colour)[0]);
        return Math.min(difference, 1 - difference) < 0.05 && seen[1] > 0.3;
    }

    /** A pixel, without its opacity. */
    public static int rgb(BufferedImage picture, double[] pixel) {
        return picture.getRGB((int) Math.round(pixel[0]), (int) Math.round(pixel[1])) & 0xffffff;
    }

    private static float[] parts(int rgb) {
        return Color.RGBtoHSB(rgb >> 16 & 0xff, rgb >> 8 & 0xff, rgb & 0xff, null);
    }
}
