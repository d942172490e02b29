// SPDX-License-Identifier: GPL-2.0-or-later
package org.auvsim.osp.drawing;

import java.util.Arrays;

/** Points p with n p = d; what cuts polygons in two. */
record Plane(double nx, double ny, double nz, double d) {
    /** What is left where nothing is left. */
    static final double[][] NOTHING = {};

    /** The plane of a polygon that is flat. */
    static Plane of(double[][] polygon) {
        double nx = 0;
        double ny = 0;
        double nz = 0;
        for (int i = 0; i < polygon.length; i++) {
            double[] a = polygon[i];
            double[] b = polygon[(i + 1) % polygon.length];
            nx += (a[1] - b[1]) * (a[2] + b[2]);
            ny += (a[2] - b[2]) * (a[0] + b[0]);
            nz += (a[0] - b[0]) * (a[1] + b[1]);
        }
        double norm = Math.max(Math.sqrt(nx * nx + ny * ny + nz * nz), Double.MIN_NORMAL);
        double[] p = polygon[0];
        return new Plane(
                nx / norm, ny / norm, nz / norm, (p[0] * nx + p[1] * ny + p[2] * nz) / norm);
    }

    Plane opposite() {
        return new Plane(-nx, -ny, -nz, -d);
    }

    /** How far a point is from it (m), on the side of the normal. */
    double above(double[] p) {
        return nx * p[0] + ny * p[1] + nz * p[2] - d;
    }

    /** The part of a convex polygon, or of a line of two places, on the side of the normal. */
    double[][] keep(double[][] polygon) {
        int inside = 0;
        for (double[] corner : polygon) {
            if (above(corner) >= 0) {
                inside++;
            }
        }
        if (inside == polygon.length) {
            return polygon;
        }
        return inside == 0 ? NOTHING : cut(polygon);
    }

    private double[][] cut(double[][] polygon) {
        double[][] kept = new double[polygon.length + 1][];
        int count = 0;
        int sides = polygon.length == 2 ? 1 : polygon.length;
        if (sides == 1 && above(polygon[0]) >= 0) {
            kept[count++] = polygon[0];
        }
        for (int i = 0; i < sides; i++) {
            double[] from = polygon[i];
            double[] to = polygon[(i + 1) % polygon.length];
            double here = above(from);
            double there = above(to);
            if ((here >= 0) != (there >= 0)) {
                kept[count++] = between(from, to, here / (here - there));
            }
            if (there >= 0) {
                kept[count++] = to;
            }
        }
        return Arrays.copyOf(kept, count);
    }

    private static double[] between(double[] from, double[] to, double part) {
        return new double[] {
            from[0] + part * (to[0] - from[0]),
            from[1] + part * (to[1] - from[1]),
            from[2] + part * (to[2] - from[2])
        };
    }
}
