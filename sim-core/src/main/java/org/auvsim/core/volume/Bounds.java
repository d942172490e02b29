package org.auvsim.core.volume;

/** Boxes along the world's axes: least x, y, z, then greatest x, y, z (m). */
final class Bounds {
    private Bounds() {}

    /** Writes the box that reaches this far from the pose's origin to both sides. */
    static void write(Pose pose, double rx, double ry, double rz, double[] to, int at) {
        to[at] = pose.x - rx;
        to[at + 1] = pose.y - ry;
        to[at + 2] = pose.z - rz;
        to[at + 3] = pose.x + rx;
        to[at + 4] = pose.y + ry;
        to[at + 5] = pose.z + rz;
    }

    /** Makes the box no smaller than this one. */
    static void include(double[] box, double[] to, int at) {
        for (int k = 0; k < 3; k++) {
            to[at + k] = Math.min(to[at + k], box[k]);
            to[at + 3 + k] = Math.max(to[at + 3 + k], box[3 + k]);
        }
    }

    /** Writes the whole of space. */
    static void writeAll(double[] to, int at) {
        for (int k = 0; k < 3; k++) {
            to[at + k] = Double.NEGATIVE_INFINITY;
            to[at + 3 + k] = Double.POSITIVE_INFINITY;
        }
    }
}
