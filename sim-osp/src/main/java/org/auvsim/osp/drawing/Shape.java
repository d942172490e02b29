// SPDX-License-Identifier: GPL-2.0-or-later
package org.auvsim.osp.drawing;

/** Faces about an origin, their corners against the clock as seen from outside. */
final class Shape {
    private final double[][][] faces;

    /** A shape of these faces, an array of corners each. */
    Shape(double[][][] faces) {
        this.faces = faces;
    }

    /** Its own array. */
    double[][][] faces() {
        return faces;
    }

    /** A ball of radius 1 with so many rings from pole to pole, and twice as many round it. */
    static Shape ball(int rings) {
        int round = 2 * rings;
        double[][][] faces = new double[rings * round][][];
        for (int i = 0; i < rings; i++) {
            for (int j = 0; j < round; j++) {
                double[] a = onBall(i, j, rings);
                double[] b = onBall(i + 1, j, rings);
                double[] c = onBall(i + 1, j + 1, rings);
                double[] d = onBall(i, j + 1, rings);
                faces[i * round + j] =
                        i == 0
                                ? new double[][] {a, b, c}
                                : i == rings - 1
                                        ? new double[][] {a, b, d}
                                        : new double[][] {a, b, c, d};
            }
        }
        return new Shape(faces);
    }

    private static double[] onBall(int i, int j, int rings) {
        double polar = Math.PI * i / rings;
        double around = Math.PI * j / rings;
        return new double[] {
            Math.sin(polar) * Math.cos(around), Math.sin(polar) * Math.sin(around), Math.cos(polar)
        };
    }

    /**
     * The side of a cylinder of radius and length 1 about the x axis, its middle at the origin, in
     * so many parts along it.
     */
    static Shape tube(int sides, int parts) {
        double[][][] faces = new double[sides * parts][][];
        for (int i = 0; i < parts; i++) {
            double from = (double) i / parts - 0.5;
            double to = (i + 1.0) / parts - 0.5;
            for (int j = 0; j < sides; j++) {
                faces[i * sides + j] =
                        new double[][] {
                            round(from, j, sides),
                            round(from, j + 1, sides),
                            round(to, j + 1, sides),
                            round(to, j, sides)
                        };
            }
        }
        return new Shape(faces);
    }

    /** A cone of radius and length 1 about the x axis, with its base, which is at the origin. */
    static Shape cone(int sides) {
        double[][][] faces = new double[sides + 1][][];
        double[][] base = new double[sides][];
        for (int j = 0; j < sides; j++) {
            faces[j] =
                    new double[][] {
                        {1, 0, 0}, round(0, j, sides), round(0, j + 1, sides),
                    };
            base[sides - 1 - j] = round(0, j, sides);
        }
        faces[sides] = base;
        return new Shape(faces);
    }

    private static double[] round(double x, int j, int sides) {
        double around = 2 * Math.PI * j / sides;
        return new double[] {x, Math.cos(around), Math.sin(around)};
    }

    /** A cube with edges of length 1 about the origin. */
    static Shape cube() {
        double[][][] faces = new double[6][4][3];
        int[][] square = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
        for (int face = 0; face < 6; face++) {
            int axis = face / 2;
            int out = face % 2 == 0 ? -1 : 1;
            for (int k = 0; k < 4; k++) {
                double[] corner = faces[face][k];
                corner[axis] = out * 0.5;
                corner[(axis + 1) % 3] = out * square[k][0] * 0.5;
                corner[(axis + 2) % 3] = square[k][1] * 0.5;
            }
        }
        return new Shape(faces);
    }

    /** A square with edges of length 1 about the origin, its normal along z. */
    static Shape square() {
        return new Shape(
                new double[][][] {
                    {{-0.5, -0.5, 0}, {0.5, -0.5, 0}, {0.5, 0.5, 0}, {-0.5, 0.5, 0}}
                });
    }
}
