// SPDX-License-Identifier: GPL-2.0-or-later
package org.auvsim.osp.drawing;

/** A flat convex polygon, or a line of two places. */
final class Face {
    private final double[][] corners;
    private final int colour;
    private final double farther;

    /**
     * @param corners in m from the view's origin
     * @param colour 0xAARRGGBB
     * @param farther so many times as far away as it is it is painted, if it is a line
     */
    Face(double[][] corners, int colour, double farther) {
        this.corners = corners;
        this.colour = colour;
        this.farther = farther;
    }

    Face(double[][] corners, int colour) {
        this(corners, colour, 1);
    }

    /** Its own array. */
    double[][] corners() {
        return corners;
    }

    int colour() {
        return colour;
    }

    double farther() {
        return farther;
    }

    /** Others of its kind. */
    Face with(double[][] others) {
        return new Face(others, colour, farther);
    }

    /** Twice its area (m²). */
    double size() {
        double x = 0;
        double y = 0;
        double z = 0;
        double[] o = corners[0];
        for (int i = 1; i + 1 < corners.length; i++) {
            double[] a = corners[i];
            double[] b = corners[i + 1];
            x += (a[1] - o[1]) * (b[2] - o[2]) - (a[2] - o[2]) * (b[1] - o[1]);
            y += (a[2] - o[2]) * (b[0] - o[0]) - (a[0] - o[0]) * (b[2] - o[2]);
            z += (a[0] - o[0]) * (b[1] - o[1]) - (a[1] - o[1]) * (b[0] - o[0]);
        }
        return Math.sqrt(x * x + y * y + z * z);
    }
}
