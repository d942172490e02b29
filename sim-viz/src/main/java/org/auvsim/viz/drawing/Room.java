package org.auvsim.viz.drawing;

import java.util.Arrays;

/** Where on the picture words stand already; lengths are parts of the picture's height. */
final class Room {
    /** A letter is about so wide for its height. */
    private static final double WIDTH = 0.55;

    /** A line of words takes so many heights of its letters. */
    private static final double LINE = 1.1;

    /** Middle from the left, middle from the top and half the width, of each. */
    private double[] taken = new double[3 * 64];

    private int count;

    void clear() {
        count = 0;
    }

    /** Takes the room of words about a middle, if none of it is taken; whether it was free. */
    boolean take(double x, double y, String words, double letters) {
        double half = words.length() * WIDTH * letters / 2;
        for (int i = 0; i < count; i += 3) {
            boolean isBeside = Math.abs(x - taken[i]) >= half + taken[i + 2];
            if (!isBeside && Math.abs(y - taken[i + 1]) < LINE * letters) {
                return false;
            }
        }
        if (count == taken.length) {
            taken = Arrays.copyOf(taken, 2 * count);
        }
        taken[count++] = x;
        taken[count++] = y;
        taken[count++] = half;
        return true;
    }
}
