package org.auvsim.viz.jme;

import java.util.Arrays;
import java.util.HashMap;
import java.util.Map;

/**
 * A ball of radius 1 from triangles of nearly one size: fewer corners than rings from pole to pole
 * need for the same roundness.
 *
 * @param places three coordinates a corner, which are its normal too
 * @param corners three of each triangle
 */
@SuppressWarnings("ArrayRecordComponent") // handed on at once, and never kept
record Icosphere(float[] places, int[] corners) {
    private static final double GOLDEN = (1 + Math.sqrt(5)) / 2;

    /** The icosahedron with its faces cut into four, so many times. */
    static Icosphere of(int cuts) {
        Icosphere ball = icosahedron();
        for (int i = 0; i < cuts; i++) {
            ball = ball.cut();
        }
        return ball;
    }

    /** The corners of three rectangles at right angles; faces join those that are nearest. */
    private static Icosphere icosahedron() {
        double scale = 1 / Math.hypot(1, GOLDEN);
        float[] places = new float[36];
        int at = 0;
        for (int axis = 0; axis < 3; axis++) {
            for (int signs = 0; signs < 4; signs++) {
                places[at + axis] = (float) ((signs & 1) == 0 ? scale : -scale);
                places[at + (axis + 1) % 3] =
                        (float) ((signs & 2) == 0 ? GOLDEN * scale : -GOLDEN * scale);
                at += 3;
            }
        }
        return new Icosphere(places, faces(places, 2.01 * scale));
    }

    /** All triples of corners that are this near to one another. */
    private static int[] faces(float[] places, double edge) {
        int[] corners = new int[60];
        int at = 0;
        for (int a = 0; a < 12; a++) {
            for (int b = a + 1; b < 12; b++) {
                for (int c = b + 1; c < 12; c++) {
                    boolean near =
                            distance(places, a, b) < edge
                                    && distance(places, b, c) < edge
                                    && distance(places, a, c) < edge;
                    if (near) {
                        corners[at++] = a;
                        corners[at++] = b;
                        corners[at++] = c;
                    }
                }
            }
        }
        return corners;
    }

    private static double distance(float[] places, int a, int b) {
        double square = 0;
        for (int axis = 0; axis < 3; axis++) {
            double d = places[3 * a + axis] - places[3 * b + axis];
            square += d * d;
        }
        return Math.sqrt(square);
    }

    private Icosphere cut() {
        Middles middles = new Middles(places);
        int[] smaller = new int[4 * corners.length];
        int at = 0;
        for (int i = 0; i < corners.length; i += 3) {
            int a = corners[i];
            int b = corners[i + 1];
            int c = corners[i + 2];
            int ab = middles.between(a, b);
            int bc = middles.between(b, c);
            int ca = middles.between(c, a);
            for (int corner : new int[] {a, ab, ca, ab, b, bc, ca, bc, c, ab, bc, ca}) {
                smaller[at++] = corner;
            }
        }
        return new Icosphere(middles.places(), smaller);
    }

    /** The corners before a cut and those in the middles of their edges, each once. */
    private static final class Middles {
        private final Map<Long, Integer> known = new HashMap<>();
        private float[] places;

        Middles(float[] before) {
            places = before.clone();
        }

        float[] places() {
            return places;
        }

        int between(int a, int b) {
            return known.computeIfAbsent(
                    ((long) Math.min(a, b) << 32) + Math.max(a, b), _ -> add(a, b));
        }

        private int add(int a, int b) {
            int next = places.length;
            places = Arrays.copyOf(places, next + 3);
            double square = 0;
            for (int axis = 0; axis < 3; axis++) {
                places[next + axis] = places[3 * a + axis] + places[3 * b + axis];
                square += places[next + axis] * places[next + axis];
            }
            for (int axis = 0; axis < 3; axis++) {
                places[next + axis] /= (float) Math.sqrt(square);
            }
            return next / 3;
        }
    }
}
