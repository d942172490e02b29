package org.auvsim.core.entity;

/** Loops over a block's arrays, each short enough for the compiler to vectorise it. */
final class Loops {
    private Loops() {}

    static void add(int count, double[] to, double[] what) {
        for (int i = 0; i < count; i++) {
            to[i] += what[i];
        }
    }

    static void subtract(int count, double[] to, double[] from, double[] what) {
        for (int i = 0; i < count; i++) {
            to[i] = from[i] - what[i];
        }
    }

    /** One row of matrices times vectors. */
    static void turn(
            int count,
            double[] to,
            double[] rx,
            double[] x,
            double[] ry,
            double[] y,
            double[] rz,
            double[] z) {
        for (int i = 0; i < count; i++) {
            to[i] = rx[i] * x[i] + ry[i] * y[i] + rz[i] * z[i];
        }
    }

    /** The same, added. */
    static void addTurned(
            int count,
            double[] to,
            double[] rx,
            double[] x,
            double[] ry,
            double[] y,
            double[] rz,
            double[] z) {
        for (int i = 0; i < count; i++) {
            to[i] += rx[i] * x[i] + ry[i] * y[i] + rz[i] * z[i];
        }
    }
}
