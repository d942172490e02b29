package org.auvsim.core.reference;

/** A place and a turn in plain numbers: what the reference computes with. */
final class Placement {
    /** Position (m). */
    final double[] at = new double[3];

    /** Rotation matrix, row by row: body to the outer frame. */
    final double[] turn = {1, 0, 0, 0, 1, 0, 0, 0, 1};

    /** Takes on a position and the turn of a quaternion (w, x, y, z) of any length. */
    void set(double x, double y, double z, double[] q) {
        at[0] = x;
        at[1] = y;
        at[2] = z;
        double n = 1 / (q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
        turn[0] = n * (q[0] * q[0] + q[1] * q[1] - q[2] * q[2] - q[3] * q[3]);
        turn[1] = n * 2 * (q[1] * q[2] - q[0] * q[3]);
        turn[2] = n * 2 * (q[1] * q[3] + q[0] * q[2]);
        turn[3] = n * 2 * (q[1] * q[2] + q[0] * q[3]);
        turn[4] = n * (q[0] * q[0] - q[1] * q[1] + q[2] * q[2] - q[3] * q[3]);
        turn[5] = n * 2 * (q[2] * q[3] - q[0] * q[1]);
        turn[6] = n * 2 * (q[1] * q[3] - q[0] * q[2]);
        turn[7] = n * 2 * (q[2] * q[3] + q[0] * q[1]);
        turn[8] = n * (q[0] * q[0] - q[1] * q[1] - q[2] * q[2] + q[3] * q[3]);
    }

    /** Becomes the placement of {@code inner}, which is given in {@code outer}. */
    void compose(Placement outer, Placement inner) {
        for (int row = 0; row < 3; row++) {
            at[row] = outer.at[row] + outer.row(row, inner.at[0], inner.at[1], inner.at[2]);
            for (int column = 0; column < 3; column++) {
                turn[3 * row + column] =
                        outer.row(
                                row,
                                inner.turn[column],
                                inner.turn[3 + column],
                                inner.turn[6 + column]);
            }
        }
    }

    private double row(int row, double x, double y, double z) {
        return turn[3 * row] * x + turn[3 * row + 1] * y + turn[3 * row + 2] * z;
    }

    /** Writes where a point of the inner frame is. */
    void outward(double x, double y, double z, double[] to, int offset) {
        for (int i = 0; i < 3; i++) {
            to[offset + i] = at[i] + row(i, x, y, z);
        }
    }

    /** One coordinate of an outer point, seen from inside. */
    double inward(int axis, double x, double y, double z) {
        return turn[axis] * (x - at[0])
                + turn[3 + axis] * (y - at[1])
                + turn[6 + axis] * (z - at[2]);
    }
}
